#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// The clock of a source: the time of the run, or with `restart` the time since the source became active. The
/// source begins anew wherever a condition puts its states back. Sources derive from it; see
/// own_time_declare.hpp.
struct OwnTime {
  bool restart = false;
  Time t{};
  DiscreteState<1> begun{};   // 1 behind the first instant
  DiscreteState<1> origin{};  // time of the run [s] at which it began

 protected:
  /// Time of the run [s] that is 0 of the source. Instants of a source are compared as instants of the run,
  /// where their rounding is known.
  double began() const { return !restart ? 0.0 : begun > 0.0 ? origin : t; }
  /// Does what update() of a source has to do; it runs only with `restart`.
  void keep_origin() {
    origin = began();
    begun = 1.0;
  }
  /// Time of the source [s].
  double own() const { return t - began(); }
};

}  // namespace stepwire
