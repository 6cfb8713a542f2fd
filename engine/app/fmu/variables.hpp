#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/app/fmu/exported_unit.hpp"
#include "engine/simulate/codegen/groups.hpp"

namespace stepwire::fmu {

/// A variable of a unit as its description has it. Numbers are SI; its value reference is its place in the
/// list.
struct Variable {
  Kind kind = Kind::output;
  std::string causality{};    ///< the word of FMI
  std::string variability{};  ///< also
  std::string name{}, about{};
  std::optional<unit::Dimension> dimension{};
  std::string shown_in{};       ///< the unit in which the file writes it; empty where that is the SI unit
  std::vector<Index> sizes{};   ///< none of one number; of a list one; of a matrix rows and columns
  std::vector<double> start{};  ///< rows of a matrix behind each other; empty where it follows from others
  std::optional<double> at_least{}, at_most{};
  std::string place{};         ///< C++ for a pointer to its first number, in the diagram d
  int rows = 1;                ///< of a matrix whose numbers lie column by column
  int block = -1;              ///< of a state or an input
  int derivative_of = -1;      ///< of a slope the place of its state in the list
  std::set<int> depends_on{};  ///< blocks of inputs and continuous states, of outputs and slopes

  std::size_t count() const;
};

/// The variables that a unit has: time, parameters, inputs, outputs, and for model exchange states, slopes
/// and event indicators. Throws Error where two would have one name.
std::vector<Variable> variables_of(const plan::Plan& plan, const codegen::Tuning& tuning, bool exchange);

}  // namespace stepwire::fmu
