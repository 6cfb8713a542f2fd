#pragma once

#include <string>
#include <vector>

#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::codegen {

/// Number or array in the interface of a generated program.
struct GroupMember {
  std::string name, meaning;
  std::vector<Index> sizes;     ///< Sizes of an array: one for a list, rows and columns for a matrix.
  std::vector<double> initial;  ///< Initial numbers, of a matrix row by row; empty for 0.
  plan::SignalSlot slot{};      ///< Place in the workspace; unused for parameters.

  /// Returns "double force_[2]".
  std::string declaration() const;
  std::size_t count() const;
};

/// Related numbers: a struct in C++ and in C.
struct Group {
  std::string type;  ///< "Inputs"
  std::string name;  ///< "inputs"
  std::string doc;
  std::vector<GroupMember> members;
};

/// Interface of a generated program of a plan. The constructor throws Error if two recorded signals would
/// have the same name.
struct Groups {
  Groups(const plan::Plan& plan, const Tuning& tuning);

  Group inputs, outputs, recorded, parameters, states;
};

/// Returns the member of `recorded` for a recorded signal.
std::string recorded_member(const diagram::RecordedSignal& signal);

}  // namespace stepwire::codegen
