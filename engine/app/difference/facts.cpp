// Facts of a file: a walk through its tree with the forms that each value may have. The forms give the unit
// of a number, the short notations of a list or section, and the default. Two notations of one value get one
// canonical text. Names of the file are marked in it, so that renames can be applied to facts.
#include "engine/app/difference/facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "engine/app/difference/notation.hpp"
#include "engine/app/reference/sections.hpp"
#include "engine/app/reference/words.hpp"
#include "engine/base/yaml/yaml_text.hpp"
#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/parameters.hpp"
#include "engine/model/diagram/written.hpp"

namespace stepwire::difference {

using Form = yaml::Key::Form;
using language::FormList;

/// Walk through the tree of one file.
class FactReader::Reading {
 public:
  Reading(FactReader& reader, const std::string& file, const yaml::Document& document)
      : reader_(reader),
        forms_(reader.forms_),
        file_(file),
        names_(document, [this](const yaml::Entry& block) { return only_output(block.value); }) {
    forms_.look_for_parts([this](const std::string& path) { return part(path); });
  }

  Fact read(const yaml::Node& node, const FormList& forms, bool literal = false) {
    if (const yaml::Key* list = node.is_list() ? nullptr : one_or_list(forms))
      if (node.kind != yaml::Node::Kind::empty) return list_of_one(node, *list, literal);
    if (node.is_list()) return list(node, forms, literal);
    if (node.is_map()) return map(node, forms);
    if (const auto section = short_section(forms)) return short_map(node, *section);
    return scalar(node, forms, literal);
  }

 private:
  static void describe(Fact& fact, const yaml::Node& node) {
    fact.node = &node;
    fact.mark = node.mark;
    fact.written = yaml::yaml_line(node);
  }

  /// Removes pointers to nodes that do not outlive the reading.
  static void forget_nodes(Fact& fact) {
    fact.node = nullptr;
    fact.entry = nullptr;
    for (Fact& part : fact.parts) forget_nodes(part);
  }

  Fact list_of_one(const yaml::Node& node, const yaml::Key& list, bool literal) {
    Fact fact{.kind = is_set(list) ? Fact::Kind::set : Fact::Kind::sequence};
    describe(fact, node);
    fact.parts.push_back(read(node, {&list.of.front()}, literal));
    fact.is_wire = fact.parts.front().is_wire;
    join_parts(fact);
    return fact;
  }

  Fact list(const yaml::Node& node, const FormList& forms, bool literal) {
    const yaml::Key* short_list = one_or_list(forms);
    Fact fact{.kind = short_list && is_set(*short_list) ? Fact::Kind::set : Fact::Kind::sequence};
    if (std::ranges::any_of(forms, [](const yaml::Key* form) { return is_set(*form); }))
      fact.kind = Fact::Kind::set;
    describe(fact, node);
    const FormList items = forms_.items(forms);
    for (const yaml::Node& item : node.items) fact.parts.push_back(read(item, items, literal));
    fact.is_wire = std::ranges::any_of(fact.parts, &Fact::is_wire);
    join_parts(fact);
    return fact;
  }

  /// Reads a section that is written as the value of its only required key.
  Fact short_map(const yaml::Node& node, const ShortSection& section) {
    Fact fact{.kind = Fact::Kind::map};
    describe(fact, node);
    if (section.required) {
      Fact value = read(node, {section.required});
      value.key = section.required->name;
      fact.parts.push_back(std::move(value));
    }
    join_parts(fact);
    return fact;
  }

  /// Reads a map that means the same as a value: numbers beside their unit, or a solver by its name alone.
  std::optional<Fact> value_in_map(const yaml::Node& node, const FormList& forms) {
    const auto numbers = numbers_with_unit(node, forms);
    const yaml::Node* solver = only_solver(node, forms);
    if (!numbers && !solver) return std::nullopt;
    Fact fact = read(numbers ? *numbers : *solver, forms);
    if (numbers) forget_nodes(fact);
    describe(fact, node);
    return fact;
  }

  Fact map(const yaml::Node& node, const FormList& forms) {
    if (auto value = value_in_map(node, forms)) return std::move(*value);
    Fact fact{.kind = Fact::Kind::map};
    describe(fact, node);
    const bool is_block =
        std::ranges::any_of(forms, [](auto* form) { return language::is_block_form(*form); });
    const yaml::Node* type = is_block ? node.find("block") : nullptr;
    const BlockType* known = type ? reader_.registry_.find(type->text) : nullptr;
    const auto value_unit = merged_unit(node, forms);
    for (const yaml::Entry& entry : node.entries) {
      if (value_unit && entry.key == "unit") continue;
      const yaml::Node& value = value_unit && entry.key == "value" ? *value_unit : entry.value;
      add_entry(fact, node, entry, value, forms, known);
    }
    if (is_block && !node.find("preset")) drop_defaults(fact, node, known);
    join_parts(fact);
    return fact;
  }

  void add_entry(Fact& fact, const yaml::Node& map, const yaml::Entry& entry, const yaml::Node& value,
                 const FormList& forms, const BlockType* known) {
    FormList below = forms_.under(forms, map, entry.key);
    if (const auto section = short_section(forms);
        section && section->required && section->value && entry.key == section->required->name)
      below = {section->value};
    const ParameterSpec* spec = known ? known->parameter(entry.key) : nullptr;
    demanded_ = spec && spec->unit == "1" ? std::optional(unit::Dimension{}) : std::nullopt;
    Fact made =
        is_bus(map, forms) && entry.key == "fields" ? bus(value) : read(value, below, spec && is_text(*spec));
    demanded_.reset();
    if (&value != &entry.value) {
      forget_nodes(made);
      made.written = yaml::yaml_line(value);
    }
    made.node = &entry.value;
    made.entry = &entry;
    made.mark = entry.mark;
    made.key = key_of(forms_.maps(forms, map), below, entry.key);
    if (below.size() == 1) made.otherwise = below.front()->otherwise;
    (is_default(made, below) ? fact.defaults : fact.parts).push_back(std::move(made));
  }

  /// Returns a key with a mark if it is a name of the file.
  std::string key_of(const FormList& maps, const FormList& below, const std::string& key) const {
    if (names_a_signal(maps, key)) return names_.any(key);
    const bool is_block =
        std::ranges::any_of(below, [](auto* form) { return language::is_block_form(*form); });
    if (is_block) return marked(NameKind::block, key);
    if (defines(below, "parameter")) return marked(NameKind::parameter, key);
    if (defines(below, "input")) return marked(NameKind::input, key);
    return defines(below, "output") ? marked(NameKind::output, key) : key;
  }

  /// True where the fact states the default of its key. Defaults of parts are compared by drop_defaults().
  bool is_default(const Fact& fact, const FormList& forms) {
    if (forms.size() != 1 || forms.front()->otherwise.empty() || fact.kind != Fact::Kind::value) return false;
    const Form form = forms.front()->form;
    if (form == Form::value || form == Form::source) return false;
    yaml::Node node;
    node.kind = yaml::Node::Kind::scalar;
    node.text = forms.front()->otherwise;
    return read(node, forms).canonical == fact.canonical;
  }

  /// Sets facts apart that state what the declaration of the block, or the file of the part, states already.
  void drop_defaults(Fact& fact, const yaml::Node& node, const BlockType* known) {
    const yaml::Node* path = node.find("block") ? nullptr : node.find("diagram");
    const auto document = path ? part(path->text) : nullptr;
    const auto defaults = std::ranges::stable_partition(fact.parts, [&](const Fact& one) {
      return known ? !is_default_of(one, *known) : !document || !is_default_of(one, *document);
    });
    std::ranges::move(defaults, std::back_inserter(fact.defaults));
    fact.parts.erase(defaults.begin(), defaults.end());
  }

  bool is_default_of(const Fact& fact, const BlockType& type) {
    if (const ParameterSpec* spec = type.parameter(fact.key)) {
      if (spec->required) return false;
      const auto node = diagram::written_value(*spec, reference::default_of(type, *spec),
                                               diagram::demanded_dimension(*spec));
      return node && same_value(fact, *node, type, spec);
    }
    const int state = diagram::state_of_key(type, fact.key);
    return state >= 0 &&
           fact.canonical == fmt::format("{}", type.states[static_cast<std::size_t>(state)].initial);
  }

  bool same_value(const Fact& fact, const yaml::Node& node, const BlockType& type,
                  const ParameterSpec* spec) {
    const yaml::Key* form = forms_.block_form(type).find(spec->name);
    demanded_ = spec->unit == "1" ? std::optional(unit::Dimension{}) : std::nullopt;
    const std::string canonical = form ? read(node, {form}, is_text(*spec)).canonical : "";
    demanded_.reset();
    return canonical == fact.canonical;
  }

  bool is_default_of(const Fact& fact, const yaml::Document& part) {
    const auto default_in = [&](const char* section, const char* key) -> const yaml::Node* {
      const yaml::Node* map = part.root.find(section);
      const yaml::Node* value = map ? map->find(fact.key) : nullptr;
      return value && value->is_map() ? value->find(key) : key == std::string("value") ? value : nullptr;
    };
    const yaml::Node* value = default_in("parameters", "value");
    if (!value) value = default_in("inputs", "default");
    if (!value || !value->is_scalar()) return false;
    const yaml::Node* owner = part.root.find("parameters");
    owner = owner ? owner->find(fact.key) : nullptr;
    const auto with_unit = owner ? merged_unit(*owner, {}) : std::nullopt;
    const std::string text = with_unit ? with_unit->text : value->text;
    const auto quantity = value->quoted ? std::nullopt : unit::parse_quantity(text);
    return quantity && fact.canonical == canonical_number(*quantity, std::nullopt);
  }

  /// Reads the fields of a bus, whose values are signals.
  Fact bus(const yaml::Node& node) {
    static const yaml::Key source = yaml::form::of(Form::source);
    if (!node.is_map()) return read(node, {&source});
    Fact fact{.kind = Fact::Kind::map, .is_wire = true};
    describe(fact, node);
    for (const yaml::Entry& entry : node.entries) {
      Fact field = bus(entry.value);
      field.key = entry.key;
      field.mark = entry.mark;
      field.entry = &entry;
      fact.parts.push_back(std::move(field));
    }
    join_parts(fact);
    return fact;
  }

  static bool is_bus(const yaml::Node& map, const FormList& forms) {
    return std::ranges::any_of(forms, [](auto* form) { return language::is_block_form(*form); }) &&
           !map.find("block") && !map.find("diagram");
  }

  Fact scalar(const yaml::Node& node, const FormList& forms, bool literal) {
    Fact fact;
    describe(fact, node);
    const ScalarForms of = scalar_forms(forms_.scalars(forms), demanded_);
    fact.is_wire = of.is_source;
    if (node.kind == yaml::Node::Kind::empty) return fact;
    const auto quantity = node.quoted ? std::nullopt : unit::parse_quantity(node.text);
    if (of.is_plain_text) {
      fact.canonical = node.text;
      return fact;
    }
    if (quantity) fact.number = quantity->value;
    // Keys such as `within` take a share of a value, or a number in its unit: 1 % is not 0.01.
    const bool of_share = !demanded_ && node.text.ends_with('%');
    if (node.quoted && of.is_value && (unit::parse_quantity(node.text) || is_truth(node.text)))
      fact.canonical = "\"" + node.text + "\"";
    else
      fact.canonical = canonical_text(node.text, {.names = names_,
                                                  .demanded = of_share ? std::nullopt : of.demanded,
                                                  .shorten = of.is_source,
                                                  .literal = literal,
                                                  .formula = of.is_value && !of.is_source,
                                                  .in_unit = of.in_unit,
                                                  .is_signal = of.is_signal});
    return fact;
  }

  std::shared_ptr<const yaml::Document> part(const std::string& path) {
    const DiagramText* found = reader_.texts_.find(reader_.texts_.part_path(file_, path));
    return found ? std::shared_ptr<const yaml::Document>(std::shared_ptr<const void>(), &found->document)
                 : nullptr;
  }

  std::string only_output(const yaml::Node& block) {
    const yaml::Node* kind = block.is_map() ? block.find("block") : nullptr;
    const BlockType* type = kind ? reader_.registry_.find(kind->text) : nullptr;
    if (type) return diagram::has_one_output(*type) ? type->outputs.front().name : "";
    const yaml::Node* path = block.is_map() && !kind ? block.find("diagram") : nullptr;
    const auto document = path ? part(path->text) : nullptr;
    const yaml::Node* outputs = document ? document->root.find("outputs") : nullptr;
    return outputs && outputs->entries.size() == 1 ? outputs->entries.front().key : "";
  }

  FactReader& reader_;
  language::Forms& forms_;
  const std::string& file_;
  FileNames names_;
  std::optional<unit::Dimension> demanded_;  ///< of the parameter that is being read
};

FileFacts FactReader::read(const std::string& file) {
  FileFacts facts{file, &texts_.read(file), {}};
  Reading reading(*this, file, facts.source->document);
  facts.root = reading.read(facts.source->document.root, forms_.root());
  return facts;
}

std::string FactReader::default_of(const Fact& block, const std::string& parameter) const {
  const BlockType* type = registry_.find(type_of(block));
  const ParameterSpec* spec = type ? type->parameter(parameter) : nullptr;
  return spec && !spec->required ? reference::default_text(*type, *spec) : "";
}

const Fact* Fact::find(std::string_view name) const {
  const auto found =
      std::ranges::find_if(parts, [&](const Fact& part) { return is_unmarked(part.key, name); });
  return found == parts.end() ? nullptr : &*found;
}

PartsByKey::PartsByKey(const Fact& map) : map_(map) {
  constexpr std::size_t few_parts = 16;
  if (map.parts.size() <= few_parts) return;
  for (const Fact& part : map.parts) parts_.emplace(unmarked(part.key), &part);
}

const Fact* PartsByKey::find(const std::string& name) const {
  if (parts_.empty()) return map_.find(name);
  const auto found = parts_.find(name);
  return found == parts_.end() ? nullptr : found->second;
}

void join_parts(Fact& fact) {
  std::vector<std::string> texts;
  for (const Fact& part : fact.parts)
    texts.push_back(part.key.empty() ? part.canonical : part.key + ": " + part.canonical);
  if (fact.kind != Fact::Kind::sequence) std::ranges::sort(texts);
  const bool is_map = fact.kind == Fact::Kind::map;
  fact.canonical = fmt::format("{}{}{}", is_map ? "{" : "[", fmt::join(texts, ", "), is_map ? "}" : "]");
}

void rename(Fact& fact, const NewNames& names) {
  fact.key = renamed(fact.key, names);
  for (Fact& part : fact.parts) rename(part, names);
  for (Fact& part : fact.defaults) rename(part, names);
  if (fact.kind == Fact::Kind::value)
    fact.canonical = renamed(fact.canonical, names);
  else
    join_parts(fact);
}

/// Returns a canonical text with new names behind those of a block: "rig.pull" for "rig.push".
static std::string renamed_behind(std::string text, const std::string& block, const NewNames& names) {
  for (const auto& [name, to] : names) {
    const std::string old_name = block + "." + name.second;
    for (std::size_t at = 0; (at = text.find(old_name, at)) != std::string::npos; ++at) {
      const std::size_t end = at + old_name.size();
      if (end < text.size() && language::is_name_character(text[end])) continue;
      text.replace(at + block.size() + 1, name.second.size(), to);
    }
  }
  return text;
}

/// Returns a canonical text with new names behind those of all these blocks.
static std::string renamed_behind(std::string text, const NamesInside& inside) {
  const std::vector<std::string> blocks = names_in(text, NameKind::block);
  for (const std::string& block : std::set(blocks.begin(), blocks.end())) {
    const auto found = inside.find(marked(NameKind::block, block));
    if (found != inside.end()) text = renamed_behind(std::move(text), found->first, found->second);
  }
  return text;
}

void rename_inside(Fact& fact, const NamesInside& inside) {
  const auto used = fact.find("diagram") ? inside.find(fact.key) : inside.end();
  fact.key = renamed_behind(fact.key, inside);
  for (Fact& part : fact.parts) {
    for (const NameKind kind : {NameKind::input, NameKind::parameter}) {
      if (used == inside.end()) break;
      if (const auto found = used->second.find({kind, part.key}); found != used->second.end())
        part.key = found->second;
    }
    rename_inside(part, inside);
  }
  if (fact.kind == Fact::Kind::value)
    fact.canonical = renamed_behind(fact.canonical, inside);
  else
    join_parts(fact);
}

std::string label_of(const Fact& item) {
  for (const char* key : {"that", "title", "name", "plot"})
    if (const Fact* named = item.find(key)) return named->node ? named->node->text : named->written;
  return item.written;
}

std::string type_of(const Fact& block) {
  if (const Fact* type = block.find("block")) return type->canonical;
  const Fact* part = block.find("diagram");
  return part ? part->canonical : "bus";
}

}  // namespace stepwire::difference
