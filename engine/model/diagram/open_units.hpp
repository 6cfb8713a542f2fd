#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "engine/model/diagram/unit_equations.hpp"
#include "engine/model/diagram/units.hpp"

namespace stepwire::diagram {

/// Unit variables of outputs with a unit unknown to their block: one for the whole output, and one for each
/// element that is read separately. Their units follow from the section `units`, from ports of parts, and
/// from the inputs that read them.
class OpenUnits {
 public:
  OpenUnits(const OutputShapes& shapes, std::size_t& variables) : shapes_(shapes), variables_(variables) {}

  /// Gives the elements of this output units of their own, overriding its block's declaration.
  void open(int block, int output) { opened_.insert({block, output}); }
  bool is_opened(int block, int output) const { return opened_.contains({block, output}); }
  /// Returns the variable of an output or one of its elements.
  int variable(const Source& source);
  int whole(int block, int output) { return variable_of({block, output}, -1); }
  /// Returns the variable of the whole output; -1 without one.
  int find(int block, int output) const;
  /// Adds equations that join the elements of each output to the whole.
  void join(UnitEquations& equations);

  ElementRange range(const Source& source) const;
  std::size_t size(int block, int output) const;

 private:
  using Output = std::pair<int, int>;
  int variable_of(const Output& output, int element);

  const OutputShapes& shapes_;
  std::size_t& variables_;
  std::set<Output> opened_;
  std::map<Output, std::map<int, int>> known_;  ///< variables by element; -1: whole
};

}  // namespace stepwire::diagram
