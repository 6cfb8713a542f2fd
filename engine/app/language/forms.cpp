#include "engine/app/language/forms.hpp"

#include <algorithm>

#include "engine/analyse/query/names_reading.hpp"
#include "engine/app/reference/sections.hpp"
#include "engine/view/plot/figure.hpp"

namespace stepwire::language {

namespace {

using Form = yaml::Key::Form;

bool is_map(const yaml::Key& form) {
  return form.form == Form::keys || form.form == Form::names;
}

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

}  // namespace stepwire::language
