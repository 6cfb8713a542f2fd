#include "engine/model/diagram/own_value.hpp"

#include <filesystem>

#include "engine/base/yaml/yaml_text.hpp"
#include "engine/model/diagram/flatten.hpp"

namespace stepwire::diagram {

namespace {

/// Returns the value of a parameter as text. One that depends on others is a number, so that it is fixed
/// where they differ.
std::string of_parameter(const DiagramParameter& parameter) {
  const double* number = std::get_if<double>(&parameter.value.content);
  if (!number || unit::parse_quantity(parameter.text)) return parameter.text;
  return value_of_number(*number, parameter.dimension).text;
}

std::optional<std::string> of_file(const Diagram& diagram, const std::string& key) {
  const auto time = unit::parse_unit("s")->dimension;
  if (key == "step") return value_of_number(diagram.step, time).text;
  if (key == "stop") return value_of_number(diagram.stop, time).text;
  if (key == "tolerance") return value_of_number(diagram.tolerance, std::nullopt).text;
  return diagram.solver.empty() ? std::nullopt : std::optional(diagram.solver);
}

std::optional<std::string> of_block(const Diagram& diagram, const Target& target) {
  const std::filesystem::path beside = std::filesystem::path(diagram.file).parent_path();
  const auto from_there = [&](const std::string& path) {
    return std::filesystem::path(path).lexically_proximate(beside).string();
  };
  const std::optional<yaml::Node> value = flattened_value(diagram, target, from_there);
  return value ? std::optional(yaml::yaml_line(*value)) : std::nullopt;
}

}  // namespace

std::optional<std::string> own_value(const Diagram& diagram, const Variation::Name& name) {
  if (name.definition >= 0)
    return of_parameter(diagram.parameters[static_cast<std::size_t>(name.definition)]);
  return name.structural ? of_file(diagram, name.text) : of_block(diagram, name.target);
}

}  // namespace stepwire::diagram
