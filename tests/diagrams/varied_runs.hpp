#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/model/diagram/variation.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire {

/// Value of a block that may have other numbers: "spring.gain", and its number.
struct Varied {
  std::string name;
  double value;
  std::string unit;
};

/// Returns parameters of blocks that are single numbers, spread over the diagram.
std::vector<Varied> varied_of(const plan::Plan& plan);
diagram::Variation variation_of(const plan::Plan& plan, const std::vector<Varied>& varied);

/// Returns a run at time 0 with the values of a run of several, each a bit larger than in the one before.
std::unique_ptr<run::Executor> run_of(const plan::Plan& plan, const std::vector<Varied>& varied,
                                      std::size_t index);
/// Runs to the end, interpreted, and records each tick.
void go_alone(run::Executor& run, std::vector<record::Recorder>& recorders);
bool same_bits(const std::vector<record::Recording>& a, const std::vector<record::Recording>& b);

/// Returns a plan of a few ticks that records each of them.
plan::Plan short_plan(const run::Job& job);

}  // namespace stepwire
