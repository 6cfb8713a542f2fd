#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/linear/linearize.hpp"
#include "engine/analyse/linear/margins.hpp"
#include "engine/analyse/linear/state_space.hpp"
#include "engine/base/result/record.hpp"

namespace stepwire::linear {

/// Analysis of one channel: one input, one output, and the states between them.
struct ChannelAnalysis {
  std::string input, output;
  std::vector<Complex> zeros;
  double gain_at_rest = 0.0;
  double bandwidth = 0.0;  ///< In rad/s.
  Margins margins;         ///< Margins of the loop closed by Linearization::feedback.
};

/// Poles, zeros, ranks and margins of a linear system.
struct Analysis : Linearization {
  std::string file{};          ///< Diagram file.
  std::vector<Mode> modes;     ///< Poles with frequency and damping.
  std::vector<Complex> zeros;  ///< Transmission zeros of the whole system.
  Stability stability;         ///< Stability of the system itself, without closing the loop.
  Rank controllable, observable;
  std::vector<ChannelAnalysis> channels;  ///< Outputs of the first input, then of the second, ...
};

/// Analyses a linear system. A `feedback`, +1 or -1, replaces that of the linearization.
Analysis analyse(Linearization linearization, std::optional<double> feedback = {});

/// Declares the fields of linear.json.
void declare(result::Record<Analysis>& is);

}  // namespace stepwire::linear
