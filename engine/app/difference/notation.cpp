#include "engine/app/difference/notation.hpp"

#include <algorithm>

#include "engine/app/reference/sections.hpp"
#include "engine/model/diagram/head_keys.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::difference {

using Form = yaml::Key::Form;
using language::FormList;

namespace {

bool is_same_form(const yaml::Key& a, const yaml::Key& b) {
  return a.form == b.form && a.refers == b.refers && a.names == b.names && a.of.size() == b.of.size();
}

const yaml::Key* one_or_list(const yaml::Key& form, int depth) {
  if (depth > 8) return nullptr;
  if (form.form == Form::section) {
    const reference::Section* section = reference::find_section(form.refers);
    return section && section->form.form == Form::either ? one_or_list(section->form, depth + 1) : nullptr;
  }
  if (form.form != Form::either) return nullptr;
  const bool is_pair = form.of.size() == 2 && form.of[1].form == Form::list;
  if (is_pair && is_same_form(form.of[0], form.of[1].of.front())) return &form.of[1];
  for (const yaml::Key& one : form.of)
    if (const yaml::Key* found = one_or_list(one, depth + 1)) return found;
  return nullptr;
}

/// Returns the section's alternatives {short form, keys}; std::nullopt for other forms.
std::optional<ShortSection> short_section(const yaml::Key& form) {
  const yaml::Key* named = &form;
  const reference::Section* section =
      form.form == Form::section ? reference::find_section(form.refers) : nullptr;
  if (section) named = &section->form;
  if (!section || named->form != Form::either || named->of.size() != 2 || named->of[1].form != Form::keys)
    return std::nullopt;
  ShortSection found;
  for (const yaml::Key& key : named->of[1].of) {
    if (!key.required) continue;
    if (found.required) return std::nullopt;
    found.required = &key;
  }
  if (!found.required) return named->of[0].form == Form::nothing ? std::optional(found) : std::nullopt;
  if (found.required->form == Form::tree) found.value = &named->of[0];
  return found;
}

void add_unit(yaml::Node& node, const std::string& unit) {
  for (yaml::Node& item : node.items) add_unit(item, unit);
  const auto quantity = node.is_scalar() && !node.quoted ? unit::parse_quantity(node.text) : std::nullopt;
  if (quantity && !quantity->dimension) node.text += " " + unit;
}

std::optional<yaml::Node> with_unit(const yaml::Node& map) {
  const yaml::Node *value = map.find("value"), *unit = map.find("unit");
  if (!value || !unit || !unit->is_scalar()) return std::nullopt;
  yaml::Node numbers = *value;
  add_unit(numbers, unit->text);
  return numbers;
}

}  // namespace

const yaml::Key* one_or_list(const FormList& forms) {
  for (const yaml::Key* form : forms)
    if (const yaml::Key* found = one_or_list(*form, 0)) return found;
  return nullptr;
}

bool is_set(const yaml::Key& list) {
  if (list.form != Form::list) return false;
  const yaml::Key& item = list.of.front();
  const bool is_signal = item.form == Form::either && item.of.front().names == yaml::Key::Names::signal &&
                         item.of.front().form == Form::text;
  return item.form == Form::section || is_signal;
}

std::optional<ShortSection> short_section(const FormList& forms) {
  for (const yaml::Key* form : forms)
    if (auto found = short_section(*form)) return found;
  return std::nullopt;
}

bool names_a_signal(const FormList& map_forms, const std::string& key) {
  return std::ranges::any_of(map_forms, [&](const yaml::Key* form) {
    if (form->form == Form::names) return form->names != yaml::Key::Names::nothing;
    const bool is_rest = !form->rest.empty() && !form->find(key);
    return is_rest && form->rest.front().names != yaml::Key::Names::nothing;
  });
}

bool defines(const FormList& forms, const std::string& section) {
  return std::ranges::any_of(
      forms, [&](const yaml::Key* form) { return form->form == Form::section && form->refers == section; });
}

std::optional<yaml::Node> numbers_with_unit(const yaml::Node& map, const FormList& forms) {
  const bool is_value = std::ranges::any_of(forms, [](const yaml::Key* form) {
    return form->form == Form::value || form->form == Form::source || form->form == Form::either;
  });
  return is_value && map.entries.size() == 2 ? with_unit(map) : std::nullopt;
}

std::optional<yaml::Node> merged_unit(const yaml::Node& map, const FormList& forms) {
  const auto section = short_section(forms);
  if (!forms.empty() && !(section && section->value)) return std::nullopt;
  return map.is_map() ? with_unit(map) : std::nullopt;
}

const yaml::Node* only_solver(const yaml::Node& map, const FormList& forms) {
  const bool is_solver =
      std::ranges::any_of(forms, [](const yaml::Key* form) { return form->name == "solver"; });
  const yaml::Node* name = is_solver && map.entries.size() == 1 ? map.find("name") : nullptr;
  if (!name || !name->is_scalar()) return nullptr;
  const bool has_control = solve::find_called(name->text, true).has_value();
  return has_control && !diagram::always_controls_error(name->text) ? nullptr : name;
}

ScalarForms scalar_forms(const FormList& scalars, const std::optional<unit::Dimension>& demanded) {
  ScalarForms of;
  of.demanded = demanded;
  of.is_plain_text = !scalars.empty();
  for (const yaml::Key* form : scalars) {
    const Form kind = form->form;
    const bool is_expression = kind == Form::expression || kind == Form::series;
    const bool is_number = kind == Form::number || kind == Form::computed || kind == Form::whole;
    of.is_source = of.is_source || kind == Form::source;
    of.is_signal =
        of.is_signal || kind == Form::source || is_expression || form->names != yaml::Key::Names::nothing;
    of.in_unit = of.in_unit || is_expression || form->names == yaml::Key::Names::signal;
    of.is_value =
        of.is_value || kind == Form::value || kind == Form::source || is_number || kind == Form::tree;
    const bool is_text = kind == Form::text || kind == Form::string || kind == Form::word ||
                         kind == Form::truth || kind == Form::nothing;
    of.is_plain_text = of.is_plain_text && is_text && form->names == yaml::Key::Names::nothing;
    if (is_number && form->unit.empty()) of.demanded = unit::Dimension{};
    if (!form->unit.empty() && kind != Form::text)
      if (const auto unit = unit::parse_unit(form->unit)) of.demanded = unit->dimension;
  }
  return of;
}

bool is_text(const ParameterSpec& spec) {
  using Kind = ParameterKind;
  return spec.kind == Kind::text || spec.kind == Kind::texts || spec.kind == Kind::file ||
         spec.kind == Kind::word || spec.kind == Kind::tree;
}

bool is_truth(const std::string& text) {
  return text == "true" || text == "false";
}

}  // namespace stepwire::difference
