#pragma once

#include <string>

#include "engine/model/diagram/variation.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::codegen {

/// Can a program that takes no memory call prepare() of this block?
bool can_prepare(const AnyBlock& block);

/// Finds what a generated program cannot follow: a parameter is fixed where something else than a number
/// depends on it, or a member of a block that its declaration says to follow from it (MemberSpec::follows).
class FixedValues {
 public:
  explicit FixedValues(const plan::Plan& plan) : plan_(plan) {}

  /// Why a parameter, by its index in Diagram::parameters, keeps its value; empty where it may change.
  std::string reason(std::size_t definition) const;

 private:
  std::string reason_of(const diagram::Target& target) const;
  std::string reason_of(const diagram::ValueText& text) const;
  std::string matrix_formula(const yaml::Node& node, int scope) const;
  std::string reason_of_bounds(std::size_t definition) const;

  const plan::Plan& plan_;
};

}  // namespace stepwire::codegen
