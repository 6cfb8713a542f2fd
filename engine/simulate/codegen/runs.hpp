#pragma once

#include <string>
#include <vector>

#include "engine/simulate/codegen/statements.hpp"

namespace stepwire::codegen {

/// Code of one call, or of a loop over several blocks of one type, and how much of it there is.
struct Code {
  std::string text;
  plan::Period period{};     ///< ticks at which it is called
  std::string active{};     ///< the number that is 0 while it is not called; empty: it always is
};

/// Some of these pieces, in which code of the same period stands behind one condition.
std::string with_conditions(const std::vector<Code>& code, std::size_t first, std::size_t last);

/// The calls of a table of a plan, in its order; calls of an algebraic loop with what solves it. Blocks of one type that lie one behind the other are called
/// in a loop where they are many and differ in nothing but numbers and places.
std::vector<Code> calls_of(const plan::Plan& plan, const Statements& statements,
                           const std::vector<plan::KernelCall>& batches, Phase phase, const Places& places);

/// The same for start(), of all of these blocks that have it, in their order.
std::vector<Code> starts_of(const plan::Plan& plan, const Statements& statements, const Places& places,
                            const std::vector<int>& blocks);

}  // namespace stepwire::codegen
