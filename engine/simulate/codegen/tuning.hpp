#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/model/plan/compiled_plan.hpp"

namespace stepwire::codegen {

/// A parameter that keeps its value in a generated program.
struct FixedParameter {
  std::string name;
  std::string reason;
};

/// A block that computes members again when its parameters change.
struct PreparedBlock {
  std::size_t block = 0;
  /// A number that it computes: part `part` of `member`, in BlockType::members, goes to this place of the
  /// numbers.
  struct Number {
    std::size_t number, member, part;
  };
  std::vector<Number> numbers;
};

/// What parameters may change in a generated program while it runs, and where they go. A program without any
/// has every number written in its code.
struct Tuning {
  std::vector<int> parameters;                ///< that may change, by their index in Diagram::parameters
  std::map<int, std::string> members;         ///< what these are called in C++: "rig_mass_"
  std::vector<FixedParameter> fixed;          ///< all others
  std::vector<int> bindings;                  ///< values of blocks that follow, in Bindings::bindings
  std::vector<plan::VariableBlock> variable;  ///< blocks that read numbers of a run
  std::vector<double> numbers;                ///< which these are, of the diagram as it stands
  /// Numbers that are an element of a binding's value: the number, the binding's place in `bindings`, the
  /// element.
  struct Copy {
    std::size_t number, binding, element;
  };
  std::vector<Copy> copies;
  std::vector<PreparedBlock> prepared;
  std::map<std::size_t, std::size_t>
      places;  ///< number of a place in the workspace: constants, initial values
};

/// Every parameter of the files that is a number, a list or a matrix may change, unless the plan itself
/// follows from it, or what configure() computes: that is known before a run only.
Tuning tuning_of(const plan::Plan& plan);

}  // namespace stepwire::codegen
