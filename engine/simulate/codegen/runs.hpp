#pragma once

#include <string>
#include <vector>

#include "engine/simulate/codegen/statements.hpp"

namespace stepwire::codegen {

/// Code of one call, or of a loop over several blocks of one type.
struct Code {
  std::string text;
  plan::Period period{};  ///< ticks of the call
  std::string active{};  ///< number that is 0 while the call is skipped; empty if it is unconditional
};

/// Returns the pieces [first, last), with code of the same period and guard under one condition.
std::string with_conditions(const std::vector<Code>& code, std::size_t first, std::size_t last);

/// Returns the code of a table of a plan, in its order, with the solvers of algebraic loops. Adjacent blocks
/// of one type that differ only in numbers and places are called in a loop if they are many.
std::vector<Code> calls_of(const plan::Plan& plan, const Statements& statements,
                           const std::vector<plan::KernelCall>& batches, Phase phase, const Places& places);

/// Returns the calls of start() for those of these blocks that have it, in order.
std::vector<Code> starts_of(const plan::Plan& plan, const Statements& statements, const Places& places,
                            const std::vector<int>& blocks);

}  // namespace stepwire::codegen
