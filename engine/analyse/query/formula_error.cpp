#include "engine/analyse/query/formula_error.hpp"

#include <fmt/format.h>

namespace stepwire::query {

yaml::Message unknown_parameter(const std::string& name, const SymbolTable& names) {
  std::vector<std::string> all;
  for (const auto& parameter : names.parameters) all.push_back(parameter.name);
  if (all.empty()) return fmt::format("there is no parameter '{}'; this diagram has none", name);
  return fmt::format("there is no parameter '{}'", name) + yaml::nearest_or_all(name, all, "there are");
}

yaml::Message unknown_column(const std::string& name, const SymbolTable& names) {
  std::vector<std::string> all;
  for (const auto& column : names.columns) all.push_back(column.name);
  const bool is_shown = name.starts_with("figure.") || name.starts_with("scene.");
  const auto beginning = [&](const std::string& of) {
    return of.substr(0, is_shown ? of.find('.') : of.rfind('.'));
  };
  for (const auto& drawn : names.drawn)
    if (beginning(drawn.name) == beginning(name)) all.push_back(drawn.name);
  if (!names.unknown.empty())
    return fmt::format("'{}' {}", name, names.unknown) + yaml::nearest_or_all(name, all, "there are");
  const bool is_vector = names.find(name + ".1") != nullptr;
  if (names.lacks(name) && !is_vector) return fmt::format("'{}' is not recorded; add it to 'record'", name);
  return fmt::format("'{}' is not recorded", name) + yaml::nearest_or_all(name, all, "recorded are");
}

}  // namespace stepwire::query
