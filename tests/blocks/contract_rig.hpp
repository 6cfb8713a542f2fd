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

/// The diagrams in which a block is tried, made from its declaration: each input is fed by a Lag on its way
/// from about a half to 1, required parameters have a value that is allowed.
std::vector<Wiring> wirings_of(const BlockType& type);

/// The same with signals of several elements, without optional inputs and with them; a block need not take
/// them.
std::vector<Wiring> wide_wirings_of(const BlockType& type, int elements);

/// The same with the tested block on condition: `enable` holds what decides on it, "{when: gate, states:
/// reset}", and `gate` is 1 at the ticks 0 to 2, 5 to 7, 10 to 12, ... and 0 at the others.
Wiring guarded(const Wiring& wiring, const std::string& enable);

/// The same with events that are located, and a block beside the tested one that crosses several times.
Wiring located(const Wiring& wiring);

/// Plans a wiring; nothing where it is refused and may be. Throws Error where it must not be.
std::optional<plan::Plan> plan_of(const Wiring& wiring);

/// Index of the block `tested` in its plan.
std::size_t tested_in(const plan::Plan& plan);

/// Does this output follow this input at the same instant, as declaration and configure() say?
bool feeds_through(const plan::Plan& plan, std::size_t input, std::size_t output);

/// All numbers of a run, and of one output of the tested block.
std::vector<double> numbers_of(const run::Executor& simulation);
std::vector<double> output_of(const run::Executor& simulation, std::size_t output);

/// Are signals, states and diagnostics of two workspaces the same? Slopes are the solver's own affair.
bool same_numbers(const plan::Plan& plan, const double* a, const double* b);

/// Are these the same bits?
bool same_bits(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace stepwire
