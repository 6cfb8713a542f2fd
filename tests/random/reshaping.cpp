#include "tests/random/reshaping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace stepwire::random {

namespace {

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Behind the word that begins here, and behind what follows it as ".port.2".
std::size_t end_of_word(const std::string& text, std::size_t at) {
  while (at < text.size() && is_of_word(text[at])) ++at;
  return at;
}

std::size_t end_of_reference(const std::string& text, std::size_t at) {
  at = end_of_word(text, at);
  while (at + 1 < text.size() && text[at] == '.' && is_of_word(text[at + 1])) at = end_of_word(text, at + 1);
  return at;
}

/// Where the indices of an element begin: ".2" of "n3.y.2".
std::size_t indices_of(const std::string& reference) {
  std::size_t end = reference.size();
  while (true) {
    const std::size_t dot = reference.rfind('.', end - 1);
    if (dot == std::string::npos || dot + 1 >= end) return end;
    const bool is_index = std::all_of(reference.begin() + static_cast<std::ptrdiff_t>(dot) + 1,
                                      reference.begin() + static_cast<std::ptrdiff_t>(end),
                                      [](unsigned char c) { return std::isdigit(c) != 0; });
    if (!is_index) return end;
    end = dot;
  }
}

std::set<std::string> names_of(const Sketch& sketch) {
  std::set<std::string> names;
  for (const Entry& entry : sketch.blocks) names.insert(entry.name);
  for (const Key& input : sketch.inputs) names.insert(input.name);
  return names;
}

/// Moves blocks into a part, with ports for what they read and what is read of them.
class Mover {
 public:
  Mover(const Sketch& sketch, const std::set<std::string>& moved, std::string name)
      : made_(sketch), moved_(moved), stay_(names_of(sketch)), name_(std::move(name)) {
    for (const std::string& one : moved_) stay_.erase(one);
  }

  Sketch move(const std::string& file) {
    Entry use{name_, {{"diagram", file}}};
    std::vector<Entry> all;
    std::swap(all, made_.blocks);
    for (Entry& entry : all) place(std::move(entry));
    for (Key& key : made_.head) key.value = key.name == "record" ? inside(key.value) : from_part(key.value);
    move_units();
    for (const auto& [outer, port] : ports_) use.keys.push_back({port, outer});
    pass_parameters(use);
    made_.blocks.push_back(std::move(use));
    made_.parts[file] = std::move(part_);
    return std::move(made_);
  }

 private:
  void place(Entry entry) {
    const bool moves = moved_.contains(entry.name);
    for (Key& key : entry.keys) key.value = moves ? into_part(key.value) : from_part(key.value);
    (moves ? part_ : made_).blocks.push_back(std::move(entry));
  }

  std::string into_part(const std::string& text) {
    return with_references(text, stay_, [&](const std::string& reference) {
      const std::size_t end = indices_of(reference);
      const std::string signal = reference.substr(0, end);
      const auto [port, is_new] = ports_.try_emplace(signal, fmt::format("i{}_{}", ports_.size() + 1, name_));
      if (is_new) part_.inputs.push_back({port->second, ""});
      return port->second + reference.substr(end);
    });
  }

  std::string from_part(const std::string& text) {
    return with_references(text, moved_, [&](const std::string& reference) {
      const std::size_t end = indices_of(reference);
      const std::string signal = reference.substr(0, end);
      const auto [port, is_new] =
          outputs_.try_emplace(signal, fmt::format("o{}_{}", outputs_.size() + 1, name_));
      if (is_new) part_.outputs.push_back({port->second, signal});
      return name_ + "." + port->second + reference.substr(end);
    });
  }

  std::string inside(const std::string& text) {
    return with_references(text, moved_,
                           [&](const std::string& reference) { return name_ + "." + reference; });
  }

  void move_units() {
    std::erase_if(made_.units, [&](const Key& unit) {
      const bool moves = moved_.contains(unit.name.substr(0, unit.name.find('.')));
      if (moves) part_.units.push_back(unit);
      return moves;
    });
  }

  void pass_parameters(Entry& use) {
    for (const Key& parameter : made_.parameters) {
      const bool is_used = std::ranges::any_of(part_.blocks, [&](const Entry& entry) {
        return std::ranges::any_of(entry.keys,
                                   [&](const Key& key) { return has_word(key.value, parameter.name); });
      });
      if (!is_used) continue;
      part_.parameters.push_back(parameter);
      use.keys.push_back({parameter.name, "$" + parameter.name});
    }
  }

  Sketch made_, part_;
  const std::set<std::string>& moved_;
  std::set<std::string> stay_;
  std::string name_;
  std::map<std::string, std::string> ports_,
      outputs_;  ///< by the signal outside, inside
};

bool reads_whole(const Entry& entry, const std::string& bus) {
  bool found = false;
  for (const Key& key : entry.keys)
    with_references(key.value, {bus}, [&](const std::string& reference) {
      found = found || reference == bus;
      return reference;
    });
  return found;
}

/// True for the name of a block, "n12".
bool is_block(const std::string& word) {
  return word.size() > 1 && word[0] == 'n' && std::isdigit(static_cast<unsigned char>(word[1])) != 0;
}

/// True for a solver whose states share a matrix, or the length of its steps.
bool shares_steps(const std::string& solver) {
  return solver == "rosenbrock" || solver == "sdirk" || solver == "auto" || solver.front() == '{';
}

}  // namespace

std::string with_references(const std::string& text, const std::set<std::string>& names,
                            const std::function<std::string(const std::string&)>& other) {
  std::string made;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t word = end_of_word(text, at);
    const bool is_name =
        word > at && names.contains(text.substr(at, word - at)) && (at == 0 || text[at - 1] != '.');
    const std::size_t end = is_name ? end_of_reference(text, at) : std::max(word, at + 1);
    const std::string piece = text.substr(at, end - at);
    made += is_name ? other(piece) : piece;
    at = end;
  }
  return made;
}

Sketch with_part(const Sketch& sketch, std::set<std::string>& moved, const std::string& name,
                 const std::string& file) {
  for (const Entry& bus : sketch.blocks) {
    if (!bus.find("fields")) continue;
    moved.erase(bus.name);
    for (const Entry& entry : sketch.blocks)
      if (reads_whole(entry, bus.name)) moved.erase(entry.name);
  }
  return moved.empty() ? sketch : Mover(sketch, moved, name).move(file);
}

Sketch shuffled(const Sketch& sketch, Dice& dice) {
  Sketch made = sketch;
  dice.shuffle(made.blocks);
  return made;
}

std::string renamed_word(const std::string& word) {
  return is_block(word) ? fmt::format("z{}_{}", 1000 - std::stoi(word.substr(1)), word) : word;
}

std::string word_of_same_order(const std::string& word) {
  return is_block(word) ? "n_" + word : word;
}

Sketch renamed(const Sketch& sketch, OtherWord other_word) {
  Sketch made = sketch;
  for (auto* keys : {&made.head, &made.outputs})
    for (Key& key : *keys) key.value = with_words(key.value, other_word);
  for (Key& unit : made.units) unit.name = with_words(unit.name, other_word);
  for (Entry& entry : made.blocks) {
    entry.name = other_word(entry.name);
    change_words(entry, other_word);
  }
  for (auto& [file, part] : made.parts) part = renamed(part, other_word);
  return made;
}

Sketch with_unrelated(const Sketch& sketch) {
  Sketch made = sketch;
  const std::vector<Entry> more{{"m1", {{"block", "Sine"}, {"frequency", "3 Hz"}}},
                                {"m2", {{"block", "UnitDelay"}, {"u", "m1"}}},
                                {"m3", {{"block", "Product"}, {"u", "[m1, m2]"}}}};
  made.blocks.insert(made.blocks.begin() + static_cast<std::ptrdiff_t>(made.blocks.size() / 2), more.begin(),
                     more.end());
  const std::string* solver = find_head(sketch, "solver");
  if (solver && !shares_steps(*solver))
    made.blocks.push_back({"m4", {{"block", "Lag"}, {"u", "m3"}, {"tau", "1 s"}}});
  return made;
}

const std::string* find_head(const Sketch& sketch, const std::string& name) {
  const auto found = std::ranges::find(sketch.head, name, &Key::name);
  return found == sketch.head.end() ? nullptr : &found->value;
}

}  // namespace stepwire::random
