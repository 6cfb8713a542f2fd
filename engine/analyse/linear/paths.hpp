#pragma once

#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::linear {

/// Blocks between the inputs and the outputs of an analysis.
struct Paths {
  std::vector<char> from_inputs, to_outputs;  ///< Per block: reachable from an input, and reaching an output.
  std::vector<char> samples;                  ///< Per block: acts at ticks only.

  bool on_way(std::size_t block) const { return from_inputs[block] && to_outputs[block]; }
  bool near_way(std::size_t block) const { return from_inputs[block] || to_outputs[block]; }
  /// True if a block between inputs and outputs acts at ticks only.
  bool sampled() const;
};

/// Finds the blocks on the paths from `inputs` to `outputs`. Blocks in `cut` interrupt a path.
Paths find_paths(const plan::Plan& plan, const std::vector<int>& inputs, const std::vector<int>& outputs,
                 const std::vector<int>& cut);

/// Returns the least common multiple of the periods of the sampled blocks on the paths [ticks].
std::int64_t base_period(const plan::Plan& plan, const Paths& paths);

}  // namespace stepwire::linear
