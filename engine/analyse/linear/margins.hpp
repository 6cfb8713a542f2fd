#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/linear/frequency_response.hpp"

namespace stepwire::linear {

/// Change of gain or phase that puts the closed loop on the border of stability.
struct Crossing {
  double frequency = 0.0;  ///< In rad/s; infinite for a direct path.
  double margin = 0.0;     ///< Factor, or angle [rad] from -pi to pi.
};

/// Margins of a loop L under negative feedback; the border is 1 + L = 0.
struct Margins {
  /// At all frequencies at which L is real and negative, up to `gain_up_to` [rad/s]. A delay turns L without
  /// end. Intervals with more than a thousand crossings are left out, of which `gain_left_out` is the number.
  std::vector<Crossing> gain;
  double gain_up_to = std::numeric_limits<double>::infinity();
  std::size_t gain_left_out = 0;
  std::vector<Crossing> phase;  ///< At all frequencies at which |L| = 1.
  double modulus = 0.0;         ///< Least distance of L from -1, or its limit at 0 or at infinity.
  double modulus_frequency = 0.0;
  double direct = 0.0;                ///< Gain of L at infinite frequency; 0 for a sampled loop.
  std::vector<Complex> closed_poles;  ///< Closed-loop poles of the states between input and output.
  bool stable = false;                ///< Stability of the closed loop, with all states.
  std::optional<Complex> hidden{};    ///< Unstable mode, uncontrollable or unobservable here.

  /// False for what could not be determined. A sentence for each is in `notes`.
  bool knows_gain = true, knows_phase = true, knows_modulus = true, knows_stability = true;
  std::vector<std::string> notes;

  /// Return the crossing with the factor nearest to 1, and with the angle nearest to 0. For an unstable
  /// closed loop only factors below 1 and angles below 0 count: they measure the distance from stability.
  std::optional<Crossing> worst_gain() const, worst_phase() const;
  /// Return the margin of the worst crossing: a factor, an angle [rad]. Infinite for a stable loop without a
  /// crossing. NaN for an unstable one without, and for what could not be determined.
  double gain_margin() const, phase_margin() const;
  /// Returns the least delay that uses up the phase margin [s]; infinite without a phase crossing, NaN for an
  /// unstable closed loop. It is 0 for a direct path with a gain of 1 or more, which any delay makes
  /// unstable.
  double delay() const;
  /// Returns the least distance from -1; NaN for an unstable closed loop.
  double modulus_margin() const;
};

/// Computes the margins of one input and one output under u = feedback y, so that L = -feedback * (output /
/// input). Stability is that of stability_of().
Margins margins_of(const StateSpace& all, double feedback);

/// Returns the frequency [rad/s] at which the gain first falls below 1/sqrt(2) of its value at rest. Infinite
/// if it never does, 0 if the gain at rest is 0 or infinite, NaN if that is not known or if delays in
/// parallel or in a loop let it fall beyond the frequencies that are searched.
double bandwidth(const StateSpace& system);

}  // namespace stepwire::linear
