#include "tests/random/shrink.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tests/random/reshaping.hpp"

namespace stepwire::random {

namespace {

constexpr int most_rounds = 60;
constexpr std::size_t most_at_once = 96;  ///< diagrams of a round, whose code is compiled together

const char* const literals[] = {"0.5", "[0.5, 0.3]", "[0.5, 0.3, 0.2]"};

bool is_used(const Sketch& sketch, const std::string& word) {
  const auto in = [&](const std::vector<Key>& keys) {
    return std::ranges::any_of(keys, [&](const Key& key) { return has_word(key.value, word); });
  };
  return in(sketch.head) || in(sketch.outputs) ||
         std::ranges::any_of(sketch.blocks, [&](const Entry& entry) { return in(entry.keys); });
}

std::set<std::string> names_of(const Sketch& sketch) {
  std::set<std::string> names;
  for (const Entry& entry : sketch.blocks) names.insert(entry.name);
  return names;
}

/// Takes out what nothing uses any more.
void prune(Sketch& sketch) {
  std::erase_if(sketch.parameters, [&](const Key& one) { return !is_used(sketch, one.name); });
  const auto names = names_of(sketch);
  std::erase_if(sketch.units,
                [&](const Key& unit) { return !names.contains(unit.name.substr(0, unit.name.find('.'))); });
}

Sketch without_blocks(const Sketch& sketch, const std::set<std::string>& gone, const std::string& instead) {
  Sketch made = sketch;
  std::erase_if(made.blocks, [&](const Entry& entry) { return gone.contains(entry.name); });
  const auto replaced = [&](const std::string& text) {
    return with_references(text, gone, [&](const std::string& reference) {
      return reference.find('.') == std::string::npos ? instead : std::string("0.5");
    });
  };
  for (Entry& entry : made.blocks)
    for (Key& key : entry.keys) key.value = replaced(key.value);
  std::erase_if(made.head,
                [&](const Key& key) { return key.name != "record" && replaced(key.value) != key.value; });
  prune(made);
  return made;
}

void add_without_blocks(const Sketch& sketch, std::vector<Sketch>& all) {
  const std::size_t count = sketch.blocks.size();
  for (std::size_t piece = count / 2; piece > 0; piece = piece > 3 ? piece / 2 : piece - 1)
    for (std::size_t first = 0; first < count; first += piece) {
      std::set<std::string> gone;
      for (std::size_t i = first; i < std::min(count, first + piece); ++i) gone.insert(sketch.blocks[i].name);
      for (const char* literal : literals) all.push_back(without_blocks(sketch, gone, literal));
    }
}

void add_without_head(const Sketch& sketch, std::vector<Sketch>& all) {
  for (const Key& key : sketch.head) {
    if (key.name == "step") continue;
    Sketch made = sketch;
    Key& own = *std::ranges::find(made.head, key.name, &Key::name);
    if (key.name == "stop")
      own.value = fmt::format("{} s", 0.5 * std::stod(key.value));
    else if (key.name == "record")
      own.value = "all";
    else
      std::erase_if(made.head, [&](const Key& one) { return one.name == key.name; });
    if (text_of(made) != text_of(sketch)) all.push_back(std::move(made));
  }
}

void add_without_keys(const Sketch& sketch, std::vector<Sketch>& all) {
  const auto names = names_of(sketch);
  for (std::size_t b = 0; b < sketch.blocks.size(); ++b)
    for (std::size_t k = 0; k < sketch.blocks[b].keys.size(); ++k) {
      const Key& key = sketch.blocks[b].keys[k];
      if (key.name == "block" || key.name == "diagram") continue;
      Sketch made = sketch;
      std::vector<Key>& keys = made.blocks[b].keys;
      keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(k));
      prune(made);
      all.push_back(std::move(made));
      if (with_references(key.value, names, [](const std::string&) { return "0.5"; }) == key.value) continue;
      made = sketch;
      made.blocks[b].keys[k].value = "0.5";
      prune(made);
      all.push_back(std::move(made));
    }
}

double steps_of(const Sketch& sketch) {
  const std::string *step = find_head(sketch, "step"), *stop = find_head(sketch, "stop");
  return step && stop ? std::stod(*stop) / std::stod(*step) : 0.0;
}

/// True where the number of ticks is whole: half of an odd number is not.
bool has_whole_ticks(const Sketch& sketch) {
  const double steps = steps_of(sketch);
  return std::abs(steps - std::round(steps)) < 1e-6 && (steps == 0.0 || steps > 2.5);
}

}  // namespace

std::vector<Sketch> smaller(const Sketch& sketch) {
  std::vector<Sketch> all;
  add_without_blocks(sketch, all);
  add_without_head(sketch, all);
  for (const auto& [file, part] : sketch.parts)
    for (Sketch& less : smaller(part)) {
      all.push_back(sketch);
      all.back().parts[file] = std::move(less);
    }
  add_without_keys(sketch, all);
  std::erase_if(all, [&](const Sketch& one) { return one.blocks.empty() || !has_whole_ticks(one); });
  return all;
}

Failure shrunk(Trials& trials, const Failure& failure) {
  Failure least = failure;
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<Sketch> all = smaller(least.sketch);
    bool found = false;
    for (std::size_t first = 0; first < all.size() && !found; first += most_at_once) {
      const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), first + most_at_once));
      const std::vector<Sketch> some(begin, end);
      const std::vector<Verdict> verdicts = trials.check(*failure.law, failure.seed, some);
      const auto broken = std::ranges::find(verdicts, Verdict::Kind::different, &Verdict::kind);
      if (broken == verdicts.end()) continue;
      least.sketch = some[static_cast<std::size_t>(broken - verdicts.begin())];
      least.text = broken->text;
      found = true;
    }
    if (!found) break;
  }
  return least;
}

}  // namespace stepwire::random
