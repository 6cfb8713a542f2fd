#include "engine/app/language/edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>

#include "engine/app/language/known_faults.hpp"
#include "engine/app/language/tree_place.hpp"
#include "engine/app/language/wire_edits.hpp"
#include "engine/app/reference/example.hpp"
#include "engine/app/reference/words.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/model/diagram/keys.hpp"

namespace stepwire::language {

namespace {

std::string free_name(const yaml::Document& document, const std::string& section, const std::string& wanted) {
  std::string name = wanted;
  for (int i = 2; DiagramFiles::entry(document, section.c_str(), name); ++i)
    name = fmt::format("{}{}", wanted, i);
  return name;
}

/// Remover of a block's names from lists.
class Forgetting {
 public:
  Forgetting(TreeEdits& edits, DiagramFiles& files, const std::string& file, const Meaning& meaning)
      : edits_(edits), text_(files.texts().text(file)), places_(*text_) {
    const std::vector<WrittenName> names = files.names(file);  // copied: resolving names reads other files
    for (const WrittenName& name : names) {
      const auto pieces = files.pieces(file, name);
      if (!pieces.empty() && pieces.front().meaning == meaning) uses_.push_back(name.range);
    }
  }

  void forget(const yaml::Node& node) {
    std::vector<const yaml::Node*> named;
    for (const yaml::Node& item : node.items) {
      if (is_use(item))
        named.push_back(&item);
      else
        forget(item);
    }
    if (named.size() < node.items.size())
      for (const yaml::Node* item : named) edits_.remove_item(node, *item);
    for (const yaml::Entry& entry : node.entries) forget(entry.value);
  }

 private:
  bool is_use(const yaml::Node& item) const {
    if (!item.is_scalar() || !diagram::is_dotted_name(item.text)) return false;
    const TextRange range = places_.range(item);
    return std::ranges::any_of(
        uses_, [&](const TextRange& use) { return range.from <= use.from && use.to <= range.to; });
  }

  TreeEdits& edits_;
  std::shared_ptr<const std::string> text_;
  TextPlaces places_;
  std::vector<TextRange> uses_;
};

bool is_taken(const yaml::Document& document, const std::string& name) {
  return std::ranges::any_of(
      std::initializer_list<const char*>{"blocks", "inputs", "parameters"},
      [&](const char* section) { return DiagramFiles::entry(document, section, name); });
}

/// Returns an unused name similar to the given one.
std::string free_name(const yaml::Document& document, std::string wanted) {
  for (char& c : wanted)
    if (!is_name_character(c)) c = '_';
  if (wanted.empty() || !(std::isalpha(static_cast<unsigned char>(wanted[0])) || wanted[0] == '_'))
    wanted.insert(0, "block_");
  std::string name = wanted;
  for (int i = 2; is_taken(document, name); ++i) name = fmt::format("{}_{}", wanted, i);
  return name;
}

TreeEdits::Keys keys_of(DiagramFiles& files, const std::string& type) {
  if (const BlockType* known = files.registry().find(type)) return reference::required_keys(*known);
  const std::string extension = std::filesystem::path(type).extension().string();
  if (extension != ".yaml" && extension != ".yml")
    throw EditRefused(fmt::format("there is no block '{}'", text::visible(type)));
  return {{"diagram", type}};
}

/// Returns the source of each input by its name; for a list input, all sources in one value.
TreeEdits::Keys feeds_of(DiagramFiles& files, const std::string& file, const yaml::Document& document,
                         const Insert& edit) {
  TreeEdits::Keys feeds;
  for (const auto& [input, signal] : edit.inputs) {
    const std::string key = input_place(input).key, source = source_text(files, file, document, signal);
    const BlockType* type = files.registry().find(edit.type);
    if (type && type->input(key) < 0)
      throw EditRefused(fmt::format("{} has no input '{}'", edit.type, text::visible(input)));
    const auto known = std::ranges::find(feeds, key, &TreeEdits::Keys::value_type::first);
    if (known == feeds.end())
      feeds.emplace_back(key, source);
    else
      known->second += ", " + source;
  }
  for (auto& [key, sources] : feeds)
    if (sources.find(',') != std::string::npos) sources = "[" + sources + "]";
  return feeds;
}

std::string usual_name(DiagramFiles& files, const std::string& type) {
  return files.registry().find(type) ? reference::snake_case(type)
                                     : std::filesystem::path(type).stem().string();
}

/// Removes a block, part or parameter. Its names are also removed from lists outside of `blocks` that have
/// other items. Other uses stay and become faults. Throws EditRefused for an unknown name.
void remove(TreeEdits& edits, DiagramFiles& files, const std::string& file, const yaml::Document& document,
            const Remove& edit) {
  const bool is_block = DiagramFiles::entry(document, "blocks", edit.name) != nullptr;
  const char* section = is_block ? "blocks" : "parameters";
  const yaml::Entry* entry = DiagramFiles::entry(document, section, edit.name);
  if (!entry) throw EditRefused(fmt::format("this file has no '{}'", text::visible(edit.name)));
  edits.remove(*document.root.find(section), *entry);
  Forgetting uses(edits, files, file,
                  {file, is_block ? Meaning::Kind::block : Meaning::Kind::parameter, edit.name});
  for (const yaml::Entry& one : document.root.entries)
    if (one.key != "blocks" && one.key != "parameters") uses.forget(one.value);
}

/// Adds a block with its required keys and its sources, and returns its name. Throws EditRefused for an
/// unknown type, and for wires with unknown ends.
std::string insert(TreeEdits& edits, DiagramFiles& files, const std::string& file,
                   const yaml::Document& document, const Insert& edit) {
  TreeEdits::Keys keys = keys_of(files, edit.type);
  std::ranges::move(feeds_of(files, file, document, edit), std::back_inserter(keys));
  if (!edit.name.empty() && (!diagram::is_dotted_name(edit.name) || is_taken(document, edit.name)))
    throw EditRefused(fmt::format("'{}' is no name, or is taken", text::visible(edit.name)));
  const std::string name = edit.name.empty() ? free_name(document, usual_name(files, edit.type)) : edit.name;
  const yaml::Node* blocks = document.root.find("blocks");
  if (blocks && blocks->is_map()) {
    edits.add_map(*blocks, name, keys);
    return name;
  }
  std::string text;
  for (const auto& [key, value] : keys) text += (text.empty() ? "" : ", ") + key + ": " + value;
  text = fmt::format("{{{}: {{{}}}}}", name, text);
  if (blocks)
    edits.replace(*blocks, text);
  else
    edits.add(document.root, "blocks", text);
  return name;
}

std::optional<std::size_t> index_in(const std::string& text, std::size_t count) {
  std::size_t index = 0;
  const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), index);
  const bool is_whole = wrong == std::errc() && end == text.data() + text.size();
  return is_whole && index >= 1 && index <= count ? std::optional(index - 1) : std::nullopt;
}

/// Returns the value under "gain" or "gain.2" of a map; nullptr if there is no such key.
const yaml::Node* value_under(const yaml::Node& map, const std::string& name) {
  if (const yaml::Node* value = map.find(name)) return value;
  const std::size_t dot = name.rfind('.');
  const yaml::Node* list = dot == std::string::npos ? nullptr : value_under(map, name.substr(0, dot));
  const auto index = list ? index_in(name.substr(dot + 1), list->items.size()) : std::nullopt;
  return index ? &list->items[*index] : nullptr;
}

[[noreturn]] void refuse_name(const std::string& name) {
  throw EditRefused(fmt::format("this file has no '{}'", text::visible(name)));
}

/// Replaces the value of a name, or adds the key to its block.
void set_value(TreeEdits& edits, const yaml::Document& document, const SetValue& set) {
  if (const yaml::Entry* block = DiagramFiles::block_at_start(document, set.name);
      block && set.name.size() > block->key.size()) {
    const std::string key = set.name.substr(block->key.size() + 1);
    if (const yaml::Node* value = value_under(block->value, key)) return edits.replace(*value, set.text);
    if (key.find('.') != std::string::npos)
      throw EditRefused(fmt::format("'{}' has no '{}' in this file", block->key, text::visible(key)));
    return edits.add(block->value, key, set.text);
  }
  const yaml::Entry* parameter = DiagramFiles::entry(document, "parameters", set.name);
  if (parameter && parameter->value.is_map()) {
    const yaml::Node* value = parameter->value.find("value");
    return value ? edits.replace(*value, set.text) : edits.add(parameter->value, "value", set.text);
  }
  if (parameter) return edits.replace(parameter->value, set.text);
  const yaml::Node* head = document.root.find(set.name);
  if (!head || !head->is_scalar()) refuse_name(set.name);
  edits.replace(*head, set.text);
}

void set_value_at(TreeEdits& edits, const TreePlace& place, const SetValueAt& set) {
  if (!place.scalar) throw EditRefused("no value stands here");
  edits.replace(*place.scalar, set.text);
}

/// Returns the position of a name's definition.
std::size_t place_of_definition(DiagramFiles& files, const std::string& file, const std::string& name) {
  using Kind = Meaning::Kind;
  for (const Kind kind : {Kind::block, Kind::parameter, Kind::input, Kind::output})
    if (const auto place = files.definition({file, kind, name})) return place->range.from;
  refuse_name(name);
}

/// Returns a fault without its place, which is in a trial text.
std::string words_of(const yaml::Fault& fault) {
  const std::string words = fault.message.text();
  return text::visible(fault.subject.empty() ? words : fault.subject + ": " + words);
}

[[noreturn]] void refuse_for(const yaml::Fault& fault) {
  throw EditRefused(words_of(fault));
}

/// Throws the first fault that a wire causes, with the input of the wire in front where the fault is
/// elsewhere.
[[noreturn]] void refuse_wire(const Connect& wire, const std::vector<yaml::Fault>& faults) {
  const auto at_wire = [&](const yaml::Fault& fault) {
    return fault.subject == wire.to || fault.subject.starts_with(wire.to + ".");
  };
  const auto found = std::ranges::find_if(faults, at_wire);
  if (found != faults.end() || wire.to.empty()) refuse_for(found != faults.end() ? *found : faults.front());
  throw EditRefused(
      text::visible(fmt::format("{}.{} cannot take {}, since then ", wire.to, wire.input, wire.from)) +
      words_of(faults.front()));
}

/// Visitor that computes the splices of an edit.
class Editor {
 public:
  Editor(DiagramFiles& files, const std::string& file)
      : files_(files), file_(file), document_(read()), text_(files.texts().text(file)) {}

  Edited operator()(const SetValue& set) {
    TreeEdits edits(*text_, *document_);
    set_value(edits, *document_, set);
    return done(edits);
  }
  Edited operator()(const SetValueAt& set) {
    const auto place = tree_place(files_, file_, set.offset);
    if (!place) throw EditRefused("no value stands here");
    TreeEdits edits(*text_, *place->document);
    set_value_at(edits, *place, set);
    return done(edits);
  }
  Edited operator()(const Rename& edit) {
    Edited result;
    result.changes = rename(files_, file_, place_of_definition(files_, file_, edit.name), edit.to);
    return result;
  }
  Edited operator()(const Connect& edit) {
    TreeEdits edits(*text_, *document_);
    connect(edits, files_, file_, *document_, edit);
    check_units(files_, analyse(files_, file_, Depth::draft), file_, edit);
    Edited result = done(edits);
    if (!result.faults.empty()) refuse_wire(edit, result.faults);
    return result;
  }
  Edited operator()(const Disconnect& edit) {
    TreeEdits edits(*text_, *document_);
    disconnect(edits, *document_, edit);
    return done(edits);
  }
  Edited operator()(const Remove& edit) {
    TreeEdits edits(*text_, *document_);
    remove(edits, files_, file_, *document_, edit);
    return done(edits);
  }
  Edited operator()(const Insert& edit) {
    TreeEdits edits(*text_, *document_);
    const std::string name = insert(edits, files_, file_, *document_, edit);
    Edited result = done(edits);
    result.name = name;
    if (!edit.inputs.empty()) refuse_wires(result.faults, (*this)(Insert{edit.type, edit.name}).faults);
    return result;
  }
  Edited operator()(const AddItem& edit) {
    TreeEdits edits(*text_, *document_);
    edits.add_below(document_->root, edit.section, "", edit.text);
    return done(edits);
  }
  Edited operator()(const CutLoop& edit) {
    TreeEdits edits(*text_, *document_);
    const std::string name = cut_loop(edits, *document_, edit);
    Edited result = done(edits);
    result.name = name;
    return result;
  }

 private:
  std::shared_ptr<const yaml::Document> read() {
    try {
      return files_.texts().document(file_);
    } catch (const yaml::Error& error) {
      throw EditRefused(std::string("mend the file first: ") + error.what());
    }
  }

  Edited done(const TreeEdits& edits) {
    Edited result;
    result.changes[file_] = edits.checked();
    result.faults = KnownFaults(files_, file_).added_by(result.changes);
    return result;
  }

  /// Throws if the wires of an inserted block cause a fault. Faults of the block alone are allowed, since it
  /// may be incomplete.
  static void refuse_wires(const std::vector<yaml::Fault>& with, const std::vector<yaml::Fault>& without) {
    for (const yaml::Fault& fault : with) {
      const bool is_of_block = std::ranges::any_of(without, [&](const yaml::Fault& one) {
        return one.subject == fault.subject && one.message.text() == fault.message.text();
      });
      if (!is_of_block) refuse_for(fault);
    }
  }

  DiagramFiles& files_;
  const std::string& file_;
  std::shared_ptr<const yaml::Document> document_;
  std::shared_ptr<const std::string> text_;
};

std::string text_under(const json::Json& edit, const char* key) {
  const json::Json* value = edit.find(key);
  const std::string* text = value ? value->as_text() : nullptr;
  if (!text) throw EditRefused(fmt::format("this edit needs a text '{}'", key));
  return *text;
}

/// Parses an edit of a value, which may be a number, a word or an expression.
Edit value_edit(const json::Json& edit) {
  const json::Json* at = edit.find("at");
  if (!at) return SetValue{text_under(edit, "name"), text_under(edit, "text")};
  const double place = at->as_number().value_or(-1.0);
  if (!(place >= 0.0 && place <= 1e9 && place == std::floor(place)))
    throw EditRefused("'at' is a place of the text");
  return SetValueAt{static_cast<std::size_t>(place), text_under(edit, "text")};
}

Edit insert_edit(const json::Json& edit) {
  const json::Json* name = edit.find("name");
  Insert insert{text_under(edit, "type"), name && !name->is_null() ? text_under(edit, "name") : ""};
  if (const json::Json* inputs = edit.find("inputs"))
    for (const json::Json& fed : inputs->items())
      insert.inputs.emplace_back(text_under(fed, "input"), text_under(fed, "from"));
  return insert;
}

using Reading = std::function<Edit(const json::Json&)>;

const std::map<std::string, Reading>& readings() {
  static const std::map<std::string, Reading> all{
      {"number", value_edit},
      {"word", value_edit},
      {"insert", insert_edit},
      {"rename",
       [](const json::Json& e) {
         return Rename{text_under(e, "name"), text_under(e, "to")};
       }},
      {"connect",
       [](const json::Json& e) {
         return Connect{text_under(e, "from"), text_under(e, "to"), text_under(e, "input")};
       }},
      {"disconnect",
       [](const json::Json& e) {
         return Disconnect{text_under(e, "to"), text_under(e, "input")};
       }},
      {"delete", [](const json::Json& e) { return Remove{text_under(e, "name")}; }},
      {"item",
       [](const json::Json& e) {
         return AddItem{text_under(e, "section"), text_under(e, "text")};
       }},
      {"bode", [](const json::Json& e) {
         return CutLoop{text_under(e, "signal"), e.find("at") ? text_under(e, "at") : ""};
       }}};
  return all;
}

}  // namespace

std::string cut_loop(TreeEdits& edits, const yaml::Document& document, const CutLoop& edit) {
  const std::string name = free_name(document, "linear", "loop"), &signal = edit.signal;
  const std::string at = edit.at.empty() ? "" : ", at: " + edit.at;
  const auto add_analysis = [&] {
    edits.add_below(document.root, "linear", name,
                    fmt::format("{{from: {0}, to: {0}, open: {0}{1}}}", signal, at));
  };
  // An existing section is extended first, because new sections are inserted at the end of the last one.
  const bool has_figure = document.root.find("figure") != nullptr;
  if (!has_figure) add_analysis();
  edits.add_below(document.root, "figure", "",
                  fmt::format("{{plot: bode, of: {}, title: The loop opened at {}}}", name, signal));
  if (has_figure) add_analysis();
  return name;
}

Edited edited(DiagramFiles& files, const std::string& file, const Edit& edit) {
  return std::visit(Editor(files, file), edit);
}

Edit edit_of(const json::Json& edit) {
  const std::string kind = text_under(edit, "kind");
  const auto reading = readings().find(kind);
  if (reading == readings().end())
    throw EditRefused(fmt::format("there is no edit '{}'", text::visible(kind)));
  return reading->second(edit);
}

}  // namespace stepwire::language
