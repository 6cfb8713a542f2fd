#include "engine/model/diagram/open_units.hpp"

namespace stepwire::diagram {

namespace {

UnitEquation of_element(int whole, int element, std::size_t place) {
  UnitEquation equation;
  equation.terms = {{whole, 1.0, {place, 1}}, {element, -1.0}};
  equation.port = "";
  equation.joins = whole;
  return equation;
}

}  // namespace

std::size_t OpenUnits::size(int block, int output) const {
  if (shapes_.empty()) return 0;
  return shapes_[static_cast<std::size_t>(block)][static_cast<std::size_t>(output)].size;
}

ElementRange OpenUnits::range(const Source& source) const {
  const ElementIndex& element = source.element;
  if (element.is_whole()) return {};
  const auto row = static_cast<std::size_t>(element.row - 1);
  if (element.column == 0) return {row, 1};
  if (shapes_.empty()) return {0, 1, false};
  const OutputShape& shape =
      shapes_[static_cast<std::size_t>(source.block)][static_cast<std::size_t>(source.output)];
  return {static_cast<std::size_t>(element.column - 1) * (shape.size / shape.columns) + row, 1};
}

int OpenUnits::variable(const Source& source) {
  const ElementRange elements = range(source);
  const bool is_whole = elements.is_whole() || !elements.known || size(source.block, source.output) == 1;
  return variable_of({source.block, source.output}, is_whole ? -1 : static_cast<int>(elements.first));
}

int OpenUnits::variable_of(const Output& output, int element) {
  const auto [place, added] = known_[output].try_emplace(element, static_cast<int>(variables_));
  variables_ += added ? 1 : 0;
  return place->second;
}

int OpenUnits::find(int block, int output) const {
  const auto found = known_.find({block, output});
  if (found == known_.end()) return -1;
  const auto whole = found->second.find(-1);
  return whole == found->second.end() ? -1 : whole->second;
}

void OpenUnits::join(UnitEquations& equations) {
  for (auto& [output, variables] : known_) {
    const std::size_t elements = size(output.first, output.second);
    if (elements < 2 || variables.rbegin()->first < 0) continue;
    UnitJoin join;
    join.variable = variable_of(output, -1);
    for (std::size_t k = 0; k < elements; ++k) {
      UnitJoin::Piece piece{{}, false, 1};
      const int element = variable_of(output, static_cast<int>(k));
      piece.unit.terms = {{element, 1.0}};
      equations.add(of_element(join.variable, element, k), "");
      join.pieces.push_back(std::move(piece));
    }
    equations.add(std::move(join));
  }
}

}  // namespace stepwire::diagram
