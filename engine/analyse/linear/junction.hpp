#pragma once

#include <vector>

#include "engine/model/block/declare.hpp"
#include "engine/model/diagram/diagram.hpp"

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

/// Inserts a junction between an output of a block and all its readers. Returns the index of the new block. A
/// run with idle junctions has the same bits as one without.
int add_junction(diagram::Diagram& diagram, const diagram::SignalRef& output);

}  // namespace stepwire::linear
