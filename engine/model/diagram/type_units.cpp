#include "engine/model/diagram/type_units.hpp"

#include <algorithm>

namespace stepwire::diagram {

namespace {

UnitExpression read(const std::string& text, TypeUnits& units) {
  auto expression = parse_unit_expression(text).value_or(UnitExpression{true, {}, {}});
  for (auto& [name, exponent] : expression.variables)
    if (std::find(units.variables.begin(), units.variables.end(), name) == units.variables.end())
      units.variables.push_back(name);
  return expression;
}

}  // namespace

TypeUnits::TypeUnits(const BlockType& type) {
  for (const auto& spec : type.parameters) parameters.push_back(read(spec.unit, *this));
  for (const auto& spec : type.inputs) inputs.push_back(read(spec.unit, *this));
  for (const auto& spec : type.outputs) outputs.push_back(read(spec.unit, *this));
  for (const auto& spec : type.states) states.push_back(read(spec.unit, *this));
}

}  // namespace stepwire::diagram
