#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Clock of a source: the time of the run, or with `restart` the time since the source became active. The
/// source restarts when a condition resets its states. Sources derive from it; see own_time_declare.hpp.
struct OwnTime {
  bool restart = false;
  Time t{};
  DiscreteState<1> begun{};   // 1 after the first instant
  DiscreteState<1> origin{};  // time of the run [s] at the restart

 protected:
  /// Returns the time of the run [s] that is 0 of the source. Instants of a source are compared as instants
  /// of the run, whose rounding is known.
  double began() const { return !restart ? 0.0 : begun > 0.0 ? origin : t; }
  /// Stores the origin. To be called by update() of a source, which runs only with `restart`.
  void keep_origin() {
    origin = began();
    begun = 1.0;
  }
  /// Returns the time of the source [s].
  double own() const { return t - began(); }
};

}  // namespace stepwire
