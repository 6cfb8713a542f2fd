#pragma once

#include <unordered_map>
#include <vector>

#include "engine/model/diagram/open_units.hpp"
#include "engine/model/diagram/type_units.hpp"

namespace stepwire::diagram {

/// Numbers the unit variables of all blocks and adds units of ports and sources to equations.
class UnitTerms {
 public:
  UnitTerms(const Diagram& diagram, const OutputShapes& shapes)
      : diagram_(diagram), open_(shapes, variable_count_) {}
  UnitTerms(const UnitTerms&) = delete;

 protected:
  const TypeUnits& units_of(const BlockType& type) { return types_.try_emplace(&type, type).first->second; }
  const UnitExpression& output_unit(int block, int output);
  /// True where the unit of an output is unknown to its block, or given by element in the section `units`.
  bool is_open(int block, int output);
  OpenUnits& open() { return open_; }
  int variable(int block, std::size_t of_type) const {
    return first_variable_[static_cast<std::size_t>(block)] + static_cast<int>(of_type);
  }
  std::size_t variable_count() const { return variable_count_; }

  void add_variables(UnitEquations& equations);
  /// Multiplies an equation by a unit of a block to the power `sign`.
  void include(UnitEquation& equation, const UnitExpression& expression, int block, double sign,
               const ElementRange& elements = {});
  /// Divides by the unit of a source; returns false for a number without a unit.
  bool divide_by_source(UnitEquation& equation, const Source& source);
  /// Returns the units of a constant with a unit, or of its element that the source picks.
  static ElementUnits units_of_constant(const Source& source);
  UnitJoin::Piece piece_of(const Source& source);

 private:
  const Diagram& diagram_;
  std::unordered_map<const BlockType*, TypeUnits> types_;
  std::vector<int> first_variable_;
  std::size_t variable_count_ = 0;
  OpenUnits open_;
};

}  // namespace stepwire::diagram
