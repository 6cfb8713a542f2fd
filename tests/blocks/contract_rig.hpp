#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/model/block/registry.hpp"
#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire {

/// One way to use a block: which optional inputs are fed, which word is chosen.
struct Wiring {
  std::string text;  ///< the diagram; the block is called `tested`, what feeds it feed_0, feed_1, ...
  bool may_be_refused = false;  ///< a word may not go with the other values
};

/// Makes the diagrams that test a block, from its declaration. Each input is fed by a Lag that rises from
/// about 0.5 to 1; required parameters have an allowed value.
std::vector<Wiring> wirings_of(const BlockType& type);

/// The same with signals of several elements, without optional inputs and with them; a block need not take
/// them.
std::vector<Wiring> wide_wirings_of(const BlockType& type, int elements);

/// The same with the tested block on condition. `enable` is the value of that key, "{when: gate, states:
/// reset}". The signal `gate` is 1 at the ticks 0 to 2, 5 to 7, 10 to 12, ... and 0 at the others.
Wiring guarded(const Wiring& wiring, const std::string& enable);

/// The same with events that are located, and a block beside the tested one that crosses several times.
Wiring located(const Wiring& wiring);

/// Plans a wiring. Returns std::nullopt if it is refused and may be; throws Error if it must not be refused.
std::optional<plan::Plan> plan_of(const Wiring& wiring);

/// Index of the block `tested` in its plan.
std::size_t tested_in(const plan::Plan& plan);

/// True if this output depends on this input at the same instant, by declaration and configure().
bool feeds_through(const plan::Plan& plan, std::size_t input, std::size_t output);

/// All numbers of a run, and of one output of the tested block.
std::vector<double> numbers_of(const run::Executor& simulation);
std::vector<double> output_of(const run::Executor& simulation, std::size_t output);

/// True if signals, states and diagnostics of two workspaces are the same. Derivatives are internal to the
/// solver and not compared.
bool same_numbers(const plan::Plan& plan, const double* a, const double* b);

/// True if all numbers have the same bits.
bool same_bits(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace stepwire
