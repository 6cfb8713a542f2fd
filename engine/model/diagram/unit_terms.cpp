#include "engine/model/diagram/unit_terms.hpp"

#include <algorithm>

namespace stepwire::diagram {

void UnitTerms::add_variables(UnitEquations& equations) {
  first_variable_.reserve(diagram_.blocks.size());
  for (const DiagramBlock& block : diagram_.blocks) {
    first_variable_.push_back(static_cast<int>(variable_count_));
    const TypeUnits& units = units_of(block.type());
    for (std::size_t i = 0; i < units.variables.size(); ++i) {
      const auto variable = static_cast<int>(variable_count_++);
      equations.restrict_elements(variable, units.elements[i]);
      if (TypeUnits::is_of_product(units.variables[i])) equations.define_first(variable);
    }
  }
  for (const UnitDemand& demand : diagram_.unit_demands)
    if (demand.source.block >= 0 && !demand.source.element.is_whole())
      open_.open(demand.source.block, demand.source.output);
}

void UnitTerms::include(UnitEquation& equation, const UnitExpression& expression, int block, double sign,
                        const ElementRange& elements) {
  equation.constant = equation.constant.times(expression.constant, sign);
  const TypeUnits& units = units_of(diagram_.blocks[static_cast<std::size_t>(block)].type());
  for (const auto& [name, exponent] : expression.variables) {
    const auto index = std::ranges::find(units.variables, name) - units.variables.begin();
    const int variable = first_variable_[static_cast<std::size_t>(block)] + static_cast<int>(index);
    const auto known = std::ranges::find_if(equation.terms, [&](const UnitTerm& term) {
      return term.variable == variable && term.elements.is_whole() == elements.is_whole();
    });
    if (known == equation.terms.end())
      equation.terms.push_back({variable, sign * exponent, elements});
    else
      known->exponent += sign * exponent;
  }
}

const UnitExpression& UnitTerms::output_unit(int block, int output) {
  return units_of(diagram_.blocks[static_cast<std::size_t>(block)].type())
      .outputs[static_cast<std::size_t>(output)];
}

bool UnitTerms::is_open(int block, int output) {
  return output_unit(block, output).any || open_.is_opened(block, output);
}

ElementUnits UnitTerms::units_of_constant(const Source& source) {
  if (source.each.empty()) return *source.dimension;
  const ElementUnits units(source.each);
  if (source.element.is_whole()) return units;
  const auto rows = source.each.size() / static_cast<std::size_t>(source.columns);
  const auto column = static_cast<std::size_t>(std::max<Eigen::Index>(source.element.column, 1) - 1);
  return units.elements({column * rows + static_cast<std::size_t>(source.element.row) - 1, 1});
}

bool UnitTerms::divide_by_source(UnitEquation& equation, const Source& source) {
  if (source.block < 0) {
    if (!source.dimension && source.each.empty()) return false;
    equation.constant = equation.constant.times(units_of_constant(source), -1.0);
  } else if (is_open(source.block, source.output)) {
    equation.terms.push_back({open_.variable(source), -1.0});
  } else {
    include(equation, output_unit(source.block, source.output), source.block, -1.0, open_.range(source));
  }
  return true;
}

UnitJoin::Piece UnitTerms::piece_of(const Source& source) {
  UnitJoin::Piece piece;
  piece.is_bare = !divide_by_source(piece.unit, source);
  piece.unit.constant = ElementUnits().times(piece.unit.constant, -1.0);
  for (UnitTerm& term : piece.unit.terms) term.exponent = -term.exponent;
  if (!source.element.is_whole())
    piece.size = 1;
  else if (source.block < 0)
    piece.size = static_cast<std::size_t>(source.constant.size());
  else
    piece.size = open_.size(source.block, source.output);
  return piece;
}

}  // namespace stepwire::diagram
