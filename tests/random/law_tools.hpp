#pragma once

#include "tests/random/dice.hpp"
#include "tests/random/laws.hpp"

namespace stepwire::random {

/// The verdict on a difference that may be empty.
Verdict verdict_of(const std::string& difference);
Verdict skipped(const std::string& why);

/// Runs a diagram, or all points of its sweep, on this thread.
run::RunResult run(const Loaded& loaded, run::RunOptions options = {});
/// Points of a sweep without lanes.
run::RunResult one_by_one(const Loaded& sweep);

/// Choices of one law for a diagram.
Dice dice_of(const Trial& trial, std::uint64_t law);

/// The parameter that a sweep of the diagram has, and five values of it. The diagram has a parameter.
const Key& swept_parameter(const Trial& trial);
std::vector<std::string> swept_values(const Key& parameter);
/// The diagram with that sweep. Throws yaml::Error where a value is refused.
std::unique_ptr<Loaded> sweep_of(const Trial& trial);

/// The verdict on runs with steps of h, h/2, h/4, ...: `different` where their differences fall more slowly
/// than those of a method of this order. Differences below `noise` times the size of a column are rounding.
Verdict verdict_on_order(const std::vector<run::RunResult>& results, int order, double noise);
/// The law of the order of a solver, on smooth diagrams.
Verdict step_halved(const Trial& trial, BatchCode&);

/// The laws of exported units that are imported again, which step themselves or have our solver.
Verdict exported(const Trial& trial, BatchCode& code);
Verdict exported_for_exchange(const Trial& trial, BatchCode& code);

/// Laws about code of a diagram: compiled for a run, for a sweep, in lanes, as a program of its own.
const std::vector<Law>& laws_of_code();

}  // namespace stepwire::random
