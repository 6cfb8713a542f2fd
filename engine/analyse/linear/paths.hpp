#pragma once

#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::linear {

/// What leads from inputs to outputs of an analysis.
struct Paths {
  std::vector<char> from_inputs, to_outputs;  ///< for each block: is it reached, does it reach
  std::vector<char> samples;                  ///< for each block: does it act at ticks alone?

  bool on_way(std::size_t block) const { return from_inputs[block] && to_outputs[block]; }
  bool near_way(std::size_t block) const { return from_inputs[block] || to_outputs[block]; }
  /// Does something on the way act at ticks alone?
  bool sampled() const;
};

/// `inputs` and `outputs` are blocks at which ways begin and end; nothing goes through those that are cut.
Paths find_paths(const plan::Plan& plan, const std::vector<int>& inputs, const std::vector<int>& outputs,
                 const std::vector<int>& cut);

/// The least common multiple of the periods of what samples on the way [ticks].
std::int64_t base_period(const plan::Plan& plan, const Paths& paths);

}  // namespace stepwire::linear
