#include "engine/base/fmi/assignments.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "engine/base/text/count.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::fmi {

namespace {

bool may_be_set(const Variable& variable) {
  return variable.type != Type::other && variable.starts_exact &&
         variable.causality != Causality::structural && variable.causality != Causality::calculated;
}

bool is_flag(Type type) {
  return type == Type::boolean || type == Type::wide_boolean;
}

bool is_whole(Type type) {
  return type != Type::float64 && type != Type::float32 && !is_flag(type);
}

/// Returns the fault of a number that a variable may not have; an empty message if it is allowed.
yaml::Message complaint(const Variable& variable, const std::string& text, const unit::Quantity& quantity) {
  const auto own = unit::parse_unit(variable.unit == "*" ? "1" : variable.unit);
  if (quantity.dimension && own && !(*quantity.dimension == own->dimension))
    return yaml::fault_text("{} has another unit than '{}'; it is in {}", text, variable.name,
                            variable.unit == "*" ? "no unit" : variable.unit);
  if (is_whole(variable.type) && quantity.value != std::round(quantity.value))
    return yaml::fault_text("{} is not allowed; '{}' is a whole number", text, variable.name);
  if (variable.at_least && quantity.value < *variable.at_least)
    return yaml::fault_text("{} is not allowed; '{}' must be at least {}", text, variable.name,
                            *variable.at_least);
  if (variable.at_most && quantity.value > *variable.at_most)
    return yaml::fault_text("{} is not allowed; '{}' must be at most {}", text, variable.name,
                            *variable.at_most);
  return {};
}

std::optional<unit::Quantity> quantity_of(const Variable& variable, const std::string& text) {
  if (is_flag(variable.type) && (text == "true" || text == "false"))
    return unit::Quantity{text == "true" ? 1.0 : 0.0, {}};
  return unit::parse_quantity(text);
}

yaml::Message unknown(const Description& description, const std::string& name) {
  std::vector<std::string> names;
  for (const Variable& variable : description.variables)
    if (may_be_set(variable)) names.push_back(variable.name);
  const std::string all =
      names.empty() ? "it has nothing that can be set" : fmt::format("it has: {}", fmt::join(names, ", "));
  return fmt::format("the unit has no '{}' that can be set", name) + yaml::did_you_mean(name, names, all);
}

}  // namespace

ReadAssignment read_assignment(const Description& description, const std::string& name,
                               const std::vector<std::string>& values) {
  for (const Variable& variable : description.variables) {
    if (variable.name != name || !may_be_set(variable)) continue;
    if (values.size() != variable.size)
      return {{},
              fmt::format("'{}' has {}, and {} are given", name, text::counted(variable.size, "number"),
                          values.size())};
    Assignment read{&variable, {}};
    for (const std::string& text : values) {
      const auto quantity = quantity_of(variable, text);
      if (!quantity) return {{}, yaml::fault_text("'{}' is not allowed; it must be a number", text)};
      if (auto wrong = complaint(variable, text, *quantity); !wrong.empty()) return {{}, wrong};
      // A bare number is in SI, as everywhere in a diagram.
      read.numbers.push_back(quantity->value);
    }
    return {read, {}};
  }
  return {{}, unknown(description, name)};
}

}  // namespace stepwire::fmi
