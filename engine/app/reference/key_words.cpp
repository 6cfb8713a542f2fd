#include "engine/app/reference/key_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace stepwire::reference {

namespace {

using Form = yaml::Key::Form;

/// Returns the names of forms that do not depend on the key.
const std::map<Form, std::string>& fixed_words() {
  static const std::map<Form, std::string> words{{Form::text, "text"},
                                                 {Form::truth, "true or false"},
                                                 {Form::whole, "whole number"},
                                                 {Form::number, "number"},
                                                 {Form::computed, "number or expression"},
                                                 {Form::expression, "expression"},
                                                 {Form::series, "expression in UNIT"},
                                                 {Form::source, "signal or number"},
                                                 {Form::value, "value"},
                                                 {Form::nothing, "nothing"},
                                                 {Form::keys, "map"},
                                                 {Form::tree, "any"}};
  return words;
}

std::string either_text(const yaml::Key& key) {
  std::vector<std::string> forms;
  for (const yaml::Key& form : key.of)
    if (const std::string text = form_text(form); std::ranges::find(forms, text) == forms.end())
      forms.push_back(text);
  return fmt::format("{}", fmt::join(forms, ", or "));
}

std::string list_text(const yaml::Key& key) {
  const std::string item = form_text(key.of.front());
  return key.least == 2 && key.most == 2 ? "two of " + item : "list of " + item;
}

std::string default_of(const yaml::Key& key) {
  if (key.required) return "required";
  return key.choice.empty() ? key.otherwise : fmt::format("one {}", key.choice);
}

std::string meaning_of(const yaml::Key& key) {
  if (key.beside.empty()) return key.doc;
  return fmt::format("{}; beside {}", key.doc, fmt::join(key.beside, " or "));
}

void add_tables(const yaml::Key& form, const std::string& path, std::vector<ReferenceTable>& tables);

/// Adds the tables of the maps inside a form.
void add_inner(const yaml::Key& form, const std::string& path, std::vector<ReferenceTable>& tables) {
  const std::string inner = form.form == Form::names ? path + ".NAME" : path;
  for (const yaml::Key& one : form.of) add_tables(one, inner, tables);
}

ReferenceTable keys_of(const yaml::Key& map, const std::string& path) {
  ReferenceTable table{
      path.empty() ? "Keys" : "Keys of " + path, {"key", "value", "unit", "range", "default", "meaning"}, {}};
  std::vector<yaml::Key> keys = map.of;
  keys.insert(keys.end(), map.rest.begin(), map.rest.end());
  for (const yaml::Key& key : keys)
    table.rows.push_back(
        {key.name, form_text(key), key.unit, range_text(key), default_of(key), meaning_of(key)});
  return table;
}

ReferenceTable words_of(const yaml::Key& key, const std::string& path) {
  ReferenceTable table{"Words of " + path, {"word", "meaning"}, {}};
  for (const yaml::Key::Word& word : key.words) table.rows.push_back({word.word, word.doc});
  return table;
}

/// Adds words, or their key to the title of a table with the same words.
void add_words(const yaml::Key& form, const std::string& path, std::vector<ReferenceTable>& tables) {
  ReferenceTable table = words_of(form, path);
  const auto known =
      std::ranges::find_if(tables, [&](const ReferenceTable& one) { return one.rows == table.rows; });
  if (known == tables.end())
    tables.push_back(std::move(table));
  else if (!known->title.ends_with(" " + path))
    known->title += ", " + path;
}

void add_tables(const yaml::Key& form, const std::string& path, std::vector<ReferenceTable>& tables) {
  if (form.form == Form::word && !form.words.empty() && !form.words.front().doc.empty())
    add_words(form, path, tables);
  if (form.form != Form::keys) return add_inner(form, path, tables);
  ReferenceTable table = keys_of(form, path);
  drop_empty_columns(table);
  const auto is_same = [&](const ReferenceTable& known) {
    return known.title == table.title && known.rows == table.rows;
  };
  if (std::ranges::any_of(tables, is_same)) return;  // same table: the form is a map or a list of such maps
  tables.push_back(std::move(table));
  std::vector<yaml::Key> keys = form.of;
  keys.insert(keys.end(), form.rest.begin(), form.rest.end());
  for (const yaml::Key& key : keys) add_tables(key, path.empty() ? key.name : path + "." + key.name, tables);
}

}  // namespace

std::string range_text(const yaml::Key& key) {
  const bool number = key.form == Form::whole || key.form == Form::number || key.form == Form::computed;
  if (!number) return "";
  const bool low = std::isfinite(key.least), high = std::isfinite(key.most);
  if (low && high && key.least == key.most) return fmt::format("{}", key.least);
  if (low && high) return fmt::format("{} to {}", key.least, key.most);
  if (high) return fmt::format("{} or less", key.most);
  if (low) return fmt::format(fmt::runtime(key.above ? "above {}" : "{} or more"), key.least);
  return "";
}

std::string form_text(const yaml::Key& key) {
  switch (key.form) {
    case Form::string:
      return key.pattern.empty() ? "name or path" : "\"#rrggbb\"";
    case Form::word:
      return fmt::format("{}", fmt::join(stepwire::yaml::words_of(key), " | "));
    case Form::list:
      return list_text(key);
    case Form::names:
      return fmt::format("{{NAME: {}, ..}}", form_text(key.of.front()));
    case Form::either:
      return either_text(key);
    case Form::section:
      return "see " + key.refers;
    default:
      return fixed_words().at(key.form);
  }
}

std::vector<ReferenceTable> key_tables(const yaml::Key& form) {
  std::vector<ReferenceTable> tables;
  add_tables(form, "", tables);
  return tables;
}

}  // namespace stepwire::reference
