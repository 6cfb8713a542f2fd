#pragma once

#include <optional>
#include <vector>

#include "engine/analyse/linear/linearize.hpp"
#include "engine/analyse/linear/margins.hpp"
#include "engine/analyse/linear/ranks.hpp"

namespace stepwire::linear {

/// One input to one output of an analysis, by the states that lie between them.
struct ChannelAnalysis {
  std::string input, output;
  std::vector<Complex> zeros;
  double gain_at_rest = 0.0;
  double bandwidth = 0.0;  ///< [rad/s]
  Margins margins;         ///< of the loop that Linearization::feedback closes
};

/// All that follows from a linear system.
struct Analysis : Linearization {
  std::vector<Mode> modes;     ///< with the poles
  std::vector<Complex> zeros;  ///< transmission zeros of the whole system
  bool stable = false;         ///< as it is, without closing anything
  Rank controllable, observable;
  std::vector<ChannelAnalysis> channels;  ///< inputs first: all outputs of the first input, ...
};

/// `feedback`, +1 or -1, in the place of the linearization's own.
Analysis analyse(Linearization linearization, std::optional<double> feedback = {});

}  // namespace stepwire::linear
