#pragma once

#include <string>
#include <vector>

#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::codegen {

/// A number or an array of numbers that a generated program shows.
struct GroupMember {
  std::string name, meaning;
  std::vector<Index> sizes;     ///< of an array: of a list one, of a matrix rows and columns
  std::vector<double> initial;  ///< those of a matrix row by row; empty: 0
  plan::SignalSlot slot{};      ///< where it stands in the workspace; not for parameters

  /// "double force_[2]"
  std::string declaration() const;
  std::size_t count() const;
};

/// Numbers that belong together: a struct in C++ and in C.
struct Group {
  std::string type;  ///< "Inputs"
  std::string name;  ///< "inputs"
  std::string doc;
  std::vector<GroupMember> members;
};

/// What a generated program shows of a plan. Throws Error where two recorded signals would have one name.
struct Groups {
  Groups(const plan::Plan& plan, const Tuning& tuning);

  Group inputs, outputs, recorded, parameters, states;
};

/// The member of `recorded` that a recorded signal is.
std::string recorded_member(const diagram::RecordedSignal& signal);

}  // namespace stepwire::codegen
