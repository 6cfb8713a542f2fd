#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/model/plan/compiled_plan.hpp"

namespace stepwire::codegen {

/// Parameter that is fixed in a generated program.
struct FixedParameter {
  std::string name;
  std::string reason;
};

/// Block that recomputes members when its parameters change.
struct PreparedBlock {
  std::size_t block = 0;
  /// Computed number: part `part` of `member`, in BlockType::members, is stored at index `number`.
  struct Number {
    std::size_t number, member, part;
  };
  std::vector<Number> numbers;
};

/// Parameters that may change in a generated program while it runs, and the numbers that depend on them. A
/// program without any has all numbers as literals.
struct Tuning {
  std::vector<int> parameters;         ///< Parameters that may change, by their index in Diagram::parameters.
  std::map<int, std::string> members;  ///< C++ names of their members, "rig_mass_".
  std::vector<FixedParameter> fixed;   ///< All other parameters.
  std::vector<int> bindings;           ///< Dependent values of blocks, as indices of Bindings::bindings.
  std::vector<plan::VariableBlock> variable;  ///< Blocks that read numbers of a run.
  std::vector<double> numbers;                ///< Initial content of the table of numbers.
  /// Number that is an element of a binding's value: index of the number, index in `bindings`, index of the
  /// element.
  struct Copy {
    std::size_t number, binding, element;
  };
  std::vector<Copy> copies;
  std::vector<PreparedBlock> prepared;
  std::map<std::size_t, std::size_t>
      places;  ///< Number of a place in the workspace, for constants and initial values.
};

/// Returns the tuning of a plan. Every parameter that is a number, a list or a matrix may change. Exceptions
/// are those on which the plan or a result of configure() depends, which are only computed before a run.
Tuning tuning_of(const plan::Plan& plan);

}  // namespace stepwire::codegen
