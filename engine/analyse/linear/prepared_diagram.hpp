#pragma once

#include <vector>

#include "engine/analyse/linear/request.hpp"
#include "engine/analyse/linear/state_space.hpp"
#include "engine/model/block/declare.hpp"
#include "engine/model/diagram/diagram.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::linear {

/// Block in a wire that adds a number to the signal, or cuts the wire and holds a value.
struct Junction {
  Input<> u{};
  Output<> y{};
  DiscreteState<> added{};
  DiscreteState<> held{};  ///< Output instead of the signal, once the wire is cut.
  DiscreteState<1> cut{};  ///< 1: cut, 0: the signal passes.

  void outputs() {
    const bool is_cut = cut > 0.0;
    for (Index i = 0; i < y.size(); ++i) y[i] = (is_cut ? held[i] : u[i]) + added[i];
  }

  static void declare(Declare<Junction>& is);

  /// Indices of its states in the type.
  static constexpr int added_state = 0, held_state = 1, cut_state = 2;
};

/// Returns the type of these blocks; no diagram file can name it.
const BlockType& junction_type();

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

/// A number of the workspace that is a row or a column of the result.
struct Place {
  std::size_t offset = 0;
  Channel channel;
  std::size_t wire = 0;  ///< For an input: offset of the signal to which it is added.
};

/// A delay of a continuous signal that an analysis removes from the diagram. Its output is cut and becomes an
/// input of the system, and its input becomes an output.
struct TakenDelay {
  std::size_t length = 0;  ///< Offset of the delay time [s].
  double shortest = 0.0;   ///< Least possible delay time [s].
  int source = -1;         ///< Index of the block that computes the delay time; -1: a constant.
};

/// A diagram with a junction in each wire that an analysis uses, and the places of its numbers. Both plans
/// have the same memory layout.
struct PreparedDiagram {
  plan::Plan plan;                     ///< Plan with the diagram's own solver.
  plan::Plan slopes;                   ///< Plan for derivatives, whose events are not located.
  std::vector<int> junctions;          ///< Indices of the junctions.
  std::vector<int> cut;                ///< Junctions that are cut.
  std::vector<Place> inputs, outputs;  ///< Numbers added at junctions; signals.
  std::vector<int> input_blocks, output_blocks;
  std::vector<TakenDelay> delays;  ///< Removed delays; their places are the last inputs and outputs.

  /// Factor from output to input of the closed loop: 1 at a cut wire, else -1.
  double feedback = -1.0;
};

/// Inserts the junctions and plans the diagram. Throws Error for unknown names.
PreparedDiagram prepare(diagram::Diagram diagram, const Request& request);

/// Returns the SI unit of a signal; empty for an unknown or dimensionless one.
std::string unit_of(const plan::Plan& plan, const diagram::SignalRef& signal);

}  // namespace stepwire::linear
