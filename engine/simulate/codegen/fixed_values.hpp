#pragma once

#include <map>
#include <string>
#include <utility>

#include "engine/model/diagram/variation.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::codegen {

/// Can a program that takes no memory call prepare() of this block?
bool can_prepare(const AnyBlock& block);

/// Finds what a generated program cannot follow. Blocks are tried with other values: what configure() then
/// answers, and what it computes, must be what it was.
class FixedValues {
 public:
  explicit FixedValues(const plan::Plan& plan) : plan_(plan) {}

  /// Why a parameter, by its index in Diagram::parameters, keeps its value; empty where it may change.
  std::string reason(std::size_t definition);

 private:
  std::string reason_of(const diagram::Target& target);
  std::string reason_of(const diagram::ValueText& text) const;
  std::string reason_of_bounds(std::size_t definition) const;

  const plan::Plan& plan_;
  std::map<std::pair<int, int>, std::string> known_;  ///< of a block's parameters
};

}  // namespace stepwire::codegen
