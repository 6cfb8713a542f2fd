#include "engine/app/language/written_names.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "engine/analyse/query/names_reading.hpp"
#include "engine/app/reference/sections.hpp"
#include "engine/app/reference/words.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/model/block/block_type.hpp"
#include "engine/model/diagram/block_keys.hpp"
#include "engine/model/diagram/every.hpp"
#include "engine/model/diagram/guard_keys.hpp"
#include "engine/view/plot/figure.hpp"

namespace stepwire::language {

using yaml::form;

namespace {

using Form = yaml::Key::Form;

yaml::Key source_form(const InputSpec& input) {
  const yaml::Key source = form::naming(yaml::Key::Names::signal, form::of(Form::source));
  yaml::Key made = yaml::key(input.name, input.doc, input.list ? form::one_or_list(source) : source);
  made.unit = input.unit == "*" ? "" : input.unit;
  made.required = !input.optional;
  return made;
}

yaml::Key words_form(const std::vector<std::string>& words) {
  std::vector<yaml::Key::Word> all;
  for (const std::string& word : words) all.push_back({word});
  return form::words(std::move(all));
}

yaml::Key parameter_form_of(const BlockType& type, const ParameterSpec& parameter) {
  const bool word = parameter.kind == ParameterKind::word;
  const bool flag = parameter.kind == ParameterKind::flag;
  const bool tree = parameter.kind == ParameterKind::tree;
  yaml::Key made = yaml::key(parameter.name, parameter.doc,
                             word   ? words_form(parameter.words)
                             : flag ? form::truth()
                             : tree ? form::tree()
                                    : form::of(Form::value));
  made.unit = reference::fixed_unit(parameter.unit);
  made.required = parameter.required;
  made.otherwise = parameter.required ? "" : reference::default_text(type, parameter);
  made.refers = reference::allowed_text(parameter);
  return made;
}

yaml::Key preset_form(const BlockType& type) {
  std::vector<yaml::Key::Word> words;
  for (const PresetSpec& preset : type.presets) words.push_back({preset.name, preset.doc});
  return yaml::key("preset", "a named set of parameter values; keys beside it come on top",
                   form::words(std::move(words)));
}

/// Adds the keys of guards, which all blocks and parts have, unless a key of that name exists.
void add_guard_keys(std::vector<yaml::Key>& keys) {
  for (const yaml::Key& guard : diagram::guard_keys())
    if (guard.name != "guard" &&
        std::ranges::none_of(keys, [&](const yaml::Key& key) { return key.name == guard.name; }))
      keys.push_back(guard);
}

/// Returns the possible keys of a block of this type, from its declaration.
std::vector<yaml::Key> keys_of_type(const BlockType& type) {
  std::vector<yaml::Key> keys{yaml::needed(yaml::key("block", type.doc, words_form({type.name})))};
  for (const InputSpec& input : type.inputs)
    if (!diagram::has_value(type, input.name)) keys.push_back(source_form(input));
  for (const ParameterSpec& parameter : type.parameters) keys.push_back(parameter_form_of(type, parameter));
  for (const StateSpec& state : type.states)
    if (state.settable)
      keys.push_back(yaml::key(diagram::initial_key(type, state),
                               "where the state " + state.name + " starts: " + state.doc,
                               form::of(Form::value)));
  if (!type.presets.empty()) keys.push_back(preset_form(type));
  if (!type.has_continuous_state()) keys.push_back(diagram::every_key("time between two runs of this block"));
  add_guard_keys(keys);
  return keys;
}

bool is_map(const yaml::Key& form) {
  return form.form == Form::keys || form.form == Form::names;
}

std::string doc_of(const yaml::Node& declared) {
  const yaml::Node* doc = declared.is_map() ? declared.find("doc") : nullptr;
  return doc ? doc->text : "";
}

std::string text_under(const yaml::Node& declared, const char* name) {
  const yaml::Node* value = declared.is_map() ? declared.find(name) : nullptr;
  return value && value->is_scalar() ? value->text : "";
}

/// Returns the keys that a block entry of this part may have.
yaml::Key part_form(const yaml::Node& part) {
  std::vector<yaml::Key> keys{yaml::needed(yaml::key("diagram", text_under(part, "title"), form::string()))};
  if (const yaml::Node* inputs = part.find("inputs"))
    for (const yaml::Entry& input : inputs->entries) {
      keys.push_back(yaml::key(input.key, doc_of(input.value),
                               form::naming(yaml::Key::Names::signal, form::of(Form::source))));
      keys.back().unit = text_under(input.value, "unit");
      keys.back().required = !input.value.is_map() || !input.value.find("default");
    }
  if (const yaml::Node* parameters = part.find("parameters"))
    for (const yaml::Entry& parameter : parameters->entries) {
      keys.push_back(yaml::key(parameter.key, doc_of(parameter.value), form::of(Form::value)));
      keys.back().otherwise =
          parameter.value.is_scalar() ? parameter.value.text : text_under(parameter.value, "value");
    }
  const bool has_every = std::ranges::any_of(keys, [](const yaml::Key& key) { return key.name == "every"; });
  if (!has_every)
    keys.push_back(diagram::every_key("time between two runs of its blocks that have none of their own"));
  add_guard_keys(keys);
  return form::keys("a part", "", std::move(keys));
}

using Form = yaml::Key::Form;
using Sense = WrittenName::Sense;

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
std::size_t name_end(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_name_character(text[at]) ||
                              (text[at] == '.' && at + 1 < text.size() && is_name_character(text[at + 1]))))
    ++at;
  return at;
}

/// Returns the end of a number and its unit.
std::size_t number_end(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_digit(text[at]) || text[at] == '.')) ++at;
  const bool exponent = at + 1 < text.size() && (text[at] == 'e' || text[at] == 'E') &&
                        (is_digit(text[at + 1]) || (at + 2 < text.size() && is_digit(text[at + 2]) &&
                                                    !is_name_character(text[at + 1])));
  if (exponent)
    for (at += 2; at < text.size() && is_digit(text[at]);) ++at;
  std::size_t unit = at;
  while (unit < text.size() && text[unit] == ' ') ++unit;
  const std::size_t length = unit::unit_prefix(text.substr(unit), [](std::string_view) { return false; });
  return length > 0 ? unit + length : at;
}

/// Returns the end of the token at `at`, which is no name.
std::size_t past(std::string_view text, std::size_t at) {
  if (is_digit(text[at])) return number_end(text, at);
  return at + (text[at] == '\\' ? 2 : 1);
}

/// Collector of the names of a file, which traverses its tree.
class Gathering {
 public:
  Gathering(std::string_view text, Forms& forms) : places_(text), forms_(forms) {}

  std::vector<WrittenName> all(const yaml::Node& root) {
    gather(root, forms_.root());
    std::ranges::stable_sort(found_, {}, &WrittenName::range);
    const auto same = [](const WrittenName& a, const WrittenName& b) {
      return a.range == b.range && a.sense == b.sense;
    };
    found_.erase(std::unique(found_.begin(), found_.end(), same),
                 found_.end());  // aliases repeat the ranges of their anchors
    return std::move(found_);
  }

 private:
  void gather(const yaml::Node& node, const FormList& forms) {
    if (node.is_scalar()) return scalar(node, forms);
    for (const yaml::Node& item : node.items) gather(item, forms_.items(forms));
    if (!node.is_map()) return;
    const bool is_block =
        std::ranges::any_of(forms, [](const yaml::Key* form) { return is_block_form(*form); });
    for (const yaml::Entry& entry : node.entries) {
      if (is_block) key_of_block(node, entry);
      const FormList below = forms_.under(forms, node, entry.key);
      if (!is_block) key(node, entry, forms, below);
      const std::string outer = block_;
      if (std::ranges::any_of(below, [](const yaml::Key* form) { return is_block_form(*form); }))
        block_ = entry.key;
      gather(entry.value, below);
      block_ = outer;
    }
  }

  void add(const TextRange& range, std::string name, Sense sense) {
    found_.push_back({range, std::move(name), sense, block_});
  }

  /// Adds a key that defines or uses a name.
  void key(const yaml::Node& map, const yaml::Entry& entry, const FormList& forms, const FormList& below) {
    for (const yaml::Key* form : below) {
      if (is_block_form(*form)) return add(unquoted(places_.key_range(entry)), entry.key, Sense::block);
      if (form->form != Form::section) continue;
      if (form->refers == "parameter")
        return add(unquoted(places_.key_range(entry)), entry.key, Sense::defined);
      if (form->refers == "input") return add(unquoted(places_.key_range(entry)), entry.key, Sense::input);
      if (form->refers == "output") return add(unquoted(places_.key_range(entry)), entry.key, Sense::output);
    }
    for (const yaml::Key* form : forms_.maps(forms, map)) {
      const yaml::Key* named = form->form == Form::names                     ? form
                               : form->rest.empty() || form->find(entry.key) ? nullptr
                                                                             : &form->rest.front();
      if (named && form->form == Form::names && form->names == yaml::Key::Names::nothing) continue;
      if (named) name(places_.key_range(entry), entry.key, named->names);
    }
  }

  void key_of_block(const yaml::Node& map, const yaml::Entry& entry) {
    if (entry.key == "block") return add(places_.range(entry.value), entry.value.text, Sense::type);
    if (entry.key == "diagram") return add(places_.range(entry.value), entry.value.text, Sense::file);
    add(places_.key_range(entry), entry.key, map.find("block") ? Sense::block_key : Sense::part_key);
  }

  /// Adds a scalar that is a name as a whole.
  void name(const TextRange& range, const std::string& text, yaml::Key::Names what) {
    if (what == yaml::Key::Names::block) add(unquoted(range), text, Sense::inside);
    if (what == yaml::Key::Names::parameter) add(unquoted(range), text, Sense::parameter);
    if (what == yaml::Key::Names::signal) add(unquoted(range), text, Sense::signal);
  }

  TextRange unquoted(TextRange range) const {
    const std::string_view raw = range.in(places_.text());
    const bool quoted = raw.size() > 1 && (raw.front() == '"' || raw.front() == '\'');
    return quoted ? TextRange{range.from + 1, range.to - 1} : range;
  }

  void scalar(const yaml::Node& node, const FormList& forms) {
    const TextRange range = unquoted(places_.range(node));
    const std::string_view raw = range.in(places_.text());
    const bool computed = raw.starts_with('=');
    bool signals = false, parameters = computed, in_unit = false;
    for (const yaml::Key* form : forms_.scalars(forms)) {
      const bool expression = form->form == Form::expression || form->form == Form::series;
      const bool source =
          form->form == Form::source && !computed && !raw.starts_with('$') && !unit::parse_quantity(raw);
      signals = signals || expression || source ||
                (form->form != Form::source && form->names == yaml::Key::Names::signal);
      in_unit = in_unit || expression || form->names == yaml::Key::Names::signal;
      parameters = parameters || (form->form != Form::text && form->form != Form::string) || !block_.empty();
      if (form->names == yaml::Key::Names::parameter) return add(range, node.text, Sense::parameter);
      if (form->names == yaml::Key::Names::block) return add(range, node.text, Sense::inside);
    }
    const std::size_t unit = in_unit ? raw.rfind(" in ") : std::string_view::npos;
    for (const NameInText& found : names_in_expression(raw.substr(0, std::min(unit, raw.size())))) {
      const TextRange at{range.from + found.range.from, range.from + found.range.to};
      const bool parameter = found.parameter || computed;
      if (parameter ? parameters : signals)
        add(at, std::string(at.in(places_.text())), parameter ? Sense::parameter : Sense::signal);
    }
  }

  TextPlaces places_;
  Forms& forms_;
  std::vector<WrittenName> found_;
  std::string block_;
};

}  // namespace

bool is_block_form(const yaml::Key& form) {
  return form.form == Form::section && form.refers == "block";
}

FormList Forms::root() const {
  return {&reference::find_section("head")->form};
}

void Forms::expand(const yaml::Key& form, FormList& result, int depth) {
  if (depth > 8) return;
  if (form.form == Form::either)
    for (const yaml::Key& one : form.of) expand(one, result, depth + 1);
  else if (const reference::Section* section =
               form.form == Form::section ? reference::find_section(form.refers) : nullptr)
    if (form.refers == "figure")
      result.push_back(&form);
    else
      expand(section->form, result, depth + 1);
  else
    result.push_back(&form);
  if (form.form == Form::series)
    result.push_back(&query::series_form());  // a series may be a map with a label
}

FormList Forms::expanded(const FormList& forms) {
  FormList result;
  for (const yaml::Key* form : forms) expand(*form, result);
  return result;
}

FormList Forms::maps(const FormList& forms, const yaml::Node& map) {
  FormList result;
  for (const yaml::Key* form : expanded(forms)) {
    if (is_map(*form) || form->form == Form::tree) result.push_back(form);
    if (is_block_form(*form)) add_block(map, result);
    if (form->form == Form::section && (form->refers == "figure" || form->refers == "panel"))
      add_figure(map, form->refers == "panel", result);
  }
  return result;
}

FormList Forms::under(const FormList& map_forms, const yaml::Node& map, const std::string& key) {
  FormList result;
  for (const yaml::Key* form : maps(map_forms, map)) {
    if (form->form == Form::tree) {
      result.push_back(form);
    } else if (form->form == Form::names) {
      result.push_back(&form->of.front());
    } else if (const yaml::Key* found = form->find(key)) {
      result.push_back(found);
    } else if (!form->rest.empty()) {
      result.push_back(&form->rest.front());
    }
  }
  return result;
}

FormList Forms::items(const FormList& list_forms) {
  FormList result;
  for (const yaml::Key* form : expanded(list_forms))
    if (form->form == Form::list)
      result.push_back(&form->of.front());
    else if (form->form == Form::tree || form->form == Form::source || form->form == Form::value)
      result.push_back(form);
  return result;
}

FormList Forms::scalars(const FormList& forms) {
  FormList result = expanded(forms);
  std::erase_if(result, [](const yaml::Key* form) {
    return is_map(*form) || form->form == Form::list || form->form == Form::section;
  });
  return result;
}

void Forms::add_block(const yaml::Node& map, FormList& result) {
  const yaml::Node* kind = map.find("block");
  const BlockType* type = kind ? registry_.find(kind->text) : nullptr;
  const yaml::Node* path = kind ? nullptr : map.find("diagram");
  if (const auto part = path && parts_ ? parts_(path->text) : nullptr) {
    auto& made = of_parts_[part];
    if (!made) made = std::make_unique<const yaml::Key>(part_form(part->root));
    return result.push_back(made.get());
  }
  result.push_back(type ? &block_form(*type) : &any_block());
}

void Forms::add_figure(const yaml::Node& map, bool panel, FormList& result) {
  const yaml::Node* plot = map.find("plot");
  auto& made = made_[(panel ? "panel " : "plot ") + (plot ? plot->text : "")];
  if (!made && plot)
    for (yaml::Key& form : plot::plot_forms(!panel))
      if (form.name == plot->text) made = std::make_unique<const yaml::Key>(std::move(form));
  if (made)
    result.push_back(made.get());
  else
    result.insert(result.end(), {&plot::figure_form(), &plot::picture_form()});
}

const yaml::Key& Forms::block_form(const BlockType& type) {
  auto& made = made_["block " + type.name];
  if (!made) made = std::make_unique<const yaml::Key>(form::keys(type.name, "", keys_of_type(type)));
  return *made;
}

const yaml::Key& Forms::any_block() {
  auto& made = made_["block"];
  if (made) return *made;
  std::vector<yaml::Key::Word> types;
  for (const BlockType* type : registry_.types()) types.push_back({type->name, type->doc});
  yaml::Key keys = form::keys("a block", "",
                              {yaml::key("block", "kind of block", form::words(std::move(types))),
                               yaml::key("diagram", "file of a part", form::string()),
                               yaml::key("fields", "of a bus, signals under names: {force: f, torque: t}",
                                         form::naming(yaml::Key::Names::signal, form::of(Form::tree)))});
  // Without a type, any key can be an input.
  keys.rest = {form::naming(yaml::Key::Names::signal, form::of(Form::source))};
  made = std::make_unique<const yaml::Key>(std::move(keys));
  return *made;
}

bool is_name_character(char c) {
  return is_letter(c) || is_digit(c);
}

std::vector<NameInText> names_in_expression(std::string_view text) {
  std::vector<NameInText> found;
  for (std::size_t at = 0; at < text.size();) {
    const bool parameter = text[at] == '$' && at + 1 < text.size() && is_letter(text[at + 1]);
    const std::size_t begin = at + (parameter ? 1 : 0);
    if (!is_letter(text[begin])) {
      at = past(text, at);
      continue;
    }
    at = begin;
    // A parameter after '$' is one of the file itself, so its name has no dots.
    while (parameter && at < text.size() && is_name_character(text[at])) ++at;
    if (!parameter) at = name_end(text, begin);
    found.push_back({{begin, at}, parameter});
  }
  return found;
}

std::vector<WrittenName> written_names(const yaml::Document& document, std::string_view text, Forms& forms) {
  return Gathering(text, forms).all(document.root);
}

}  // namespace stepwire::language
