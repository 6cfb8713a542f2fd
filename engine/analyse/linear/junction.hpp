#pragma once

#include <vector>

#include "engine/model/block/declare.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::linear {

/// A place in a wire at which something is added to a signal, or at which it is cut and held.
struct Junction {
  Input<> u{};
  Output<> y{};
  DiscreteState<> added{};
  DiscreteState<> held{};  ///< in the place of the signal, once it is cut
  DiscreteState<1> cut{};  ///< 1: cut, 0: the signal passes

  void outputs() {
    const bool is_cut = cut > 0.0;
    for (Index i = 0; i < y.size(); ++i) y[i] = (is_cut ? held[i] : u[i]) + added[i];
  }

  static void declare(Declare<Junction>& is);

  /// The places of its states in the type.
  static constexpr int added_state = 0, held_state = 1, cut_state = 2;
};

/// The type of such blocks; no diagram file can name it.
const BlockType& junction_type();

/// Puts a junction behind an output of a block, before all that reads it, and returns its index among the
/// blocks. A run with junctions at which nothing is added or cut has the bits of one without.
int add_junction(diagram::Diagram& diagram, const diagram::SignalRef& output);

}  // namespace stepwire::linear
