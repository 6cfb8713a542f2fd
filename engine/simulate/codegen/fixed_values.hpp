#pragma once

#include <string>

#include "engine/model/diagram/variation.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::codegen {

/// True if a program without dynamic memory can call prepare() of this block.
bool can_prepare(const AnyBlock& block);

/// Finds the parameters that must be fixed in a generated program. A parameter is fixed if something else
/// than a number depends on it, or a block member that is declared to depend on it (MemberSpec::follows).
class FixedValues {
 public:
  explicit FixedValues(const plan::Plan& plan) : plan_(plan) {}

  /// Returns the reason why a parameter, by its index in Diagram::parameters, is fixed; an empty text for one
  /// that may change.
  std::string reason(std::size_t definition) const;

 private:
  std::string reason_of(const diagram::Target& target) const;
  std::string reason_of(const diagram::ValueText& text) const;
  std::string matrix_formula(const yaml::Node& node, int scope) const;
  std::string reason_of_bounds(std::size_t definition) const;

  const plan::Plan& plan_;
};

}  // namespace stepwire::codegen
