#include "engine/model/diagram/type_units.hpp"

#include <algorithm>
#include <set>

namespace stepwire::diagram {

namespace {

UnitExpression read(const std::string& text, TypeUnits& units) {
  auto expression = parse_unit_expression(text).value_or(UnitExpression{true, false, {}, {}});
  for (auto& [name, exponent] : expression.variables)
    if (std::find(units.variables.begin(), units.variables.end(), name) == units.variables.end())
      units.variables.push_back(name);
  return expression;
}

}  // namespace

bool joins_pieces(const InputSpec& spec) {
  return spec.list && spec.shape.starts_with('+') && spec.shape.find(" x ") == std::string::npos;
}

TypeUnits::TypeUnits(const BlockType& type) {
  for (const auto& spec : type.parameters) parameters.push_back(read(spec.unit, *this));
  for (const auto& spec : type.inputs) inputs.push_back(read(spec.unit, *this));
  for (const auto& spec : type.outputs) outputs.push_back(read(spec.unit, *this));
  for (const auto& spec : type.states) states.push_back(read(spec.unit, *this));
  take_products();
  for (const std::string& variable : variables) elements.push_back(elements_of(variable, type));
}

void TypeUnits::take_products() {
  for (std::size_t o = 0; o < outputs.size(); ++o) {
    if (outputs[o].variables.size() < 2) continue;
    variables.push_back("=" + std::to_string(o));
    products.push_back({o, outputs[o]});
    outputs[o] = {false, false, {}, {{variables.back(), 1.0}}};
  }
}

/// Returns the treatment of a variable's elements: it has a unit for each element if all of its ports have
/// one shape.
Elements TypeUnits::elements_of(const std::string& variable, const BlockType& type) const {
  std::set<std::string> shapes;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const InputSpec& spec = type.inputs[i];
    if (inputs[i].has(variable)) shapes.insert(joins_pieces(spec) ? spec.shape.substr(1) : spec.shape);
  }
  for (std::size_t i = 0; i < outputs.size(); ++i)
    if (outputs[i].has(variable)) shapes.insert(type.outputs[i].shape);
  for (const Product& product : products)
    if (product.unit.has(variable)) shapes.insert(type.outputs[product.output].shape);
  if (shapes.size() <= 1) return Elements::own;
  return is_scaled(variable) ? Elements::scaled : Elements::alike;
}

bool TypeUnits::is_factor(const std::string& variable) const {
  const auto is_alone = [&](const UnitExpression& input) {
    return input.has(variable) && input.variables.size() == 1;
  };
  return !is_of_product(variable) && std::ranges::none_of(inputs, is_alone) &&
         std::ranges::any_of(products, [&](const Product& one) { return one.unit.has(variable); });
}

/// True where each output with this variable has a factor that is the unit of no input.
bool TypeUnits::is_scaled(const std::string& variable) const {
  return std::ranges::none_of(outputs, [&](const UnitExpression& one) { return one.has(variable); }) &&
         std::ranges::all_of(products, [&](const Product& one) {
           return !one.unit.has(variable) || std::ranges::any_of(one.unit.variables, [&](const auto& term) {
             return is_factor(term.first);
           });
         });
}

}  // namespace stepwire::diagram
