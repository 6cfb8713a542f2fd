#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/app/fmu/exported_unit.hpp"
#include "engine/simulate/codegen/groups.hpp"

namespace stepwire::fmu {

/// Variable in a model description. Numbers are SI. Its value reference is its index in the list.
struct Variable {
  Kind kind = Kind::output;
  std::string causality{};    ///< causality in FMI's words
  std::string variability{};  ///< variability in FMI's words
  std::string name{}, about{};
  std::optional<unit::Dimension> dimension{};
  std::string shown_in{};       ///< unit in the diagram file; empty if that is SI
  std::vector<Index> sizes{};   ///< Empty for a scalar; length of a list; rows and columns of a matrix.
  std::vector<double> start{};  ///< Row-major start values; empty if other variables determine them.
  std::optional<double> at_least{}, at_most{};
  std::string place{};         ///< C++ for the address of its first number, in the diagram d.
  int rows = 1;                ///< Rows of a matrix in column-major order; else 1.
  int block = -1;              ///< Block of a state or an input.
  int derivative_of = -1;      ///< Index of the state of which this is the derivative.
  std::set<int> depends_on{};  ///< Blocks of inputs and states that affect an output or derivative.

  std::size_t count() const;
};

/// Returns the variables of a unit: time, parameters, inputs, outputs, and for model exchange states,
/// derivatives and event indicators. Throws Error for two equal names.
std::vector<Variable> variables_of(const plan::Plan& plan, const codegen::Tuning& tuning, bool exchange);

}  // namespace stepwire::fmu
