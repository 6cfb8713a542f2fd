#pragma once

#include <optional>
#include <vector>

#include "engine/analyse/linear/frequency_response.hpp"

namespace stepwire::linear {

/// Where the loop's gain may change by a factor, or its phase by an angle, until the closed loop is on the
/// border of stability.
struct Crossing {
  double frequency = 0.0;  ///< [rad/s]; infinite where the loop passes its signal at once
  double margin = 0.0;     ///< factor, or angle [rad] from -pi to pi
};

/// The margins of a loop L that is closed by negative feedback: 1 + L = 0 is the border.
struct Margins {
  std::vector<Crossing> gain;   ///< of all frequencies at which L is real and negative
  std::vector<Crossing> phase;  ///< of all frequencies at which |L| = 1
  double modulus = 0.0;         ///< least distance of L from -1
  double modulus_frequency = 0.0;
  std::vector<Complex> closed_poles;  ///< of the states between input and output
  bool stable = false;                ///< of the closed loop, with all states
  std::optional<Complex> hidden{};    ///< a mode that grows, and that input or output have no part in

  /// The crossing whose factor is nearest to 1, or whose angle is nearest to 0. Of a closed loop that is not
  /// stable only factors below 1 and angles below 0 count: how far it is from stable.
  std::optional<Crossing> worst_gain() const, worst_phase() const;
  /// The least delay by which the phase margins are used up [s]; infinite without any, NaN where the closed
  /// loop is not stable.
  double delay() const;
};

/// Of one input and one output, closed by u = feedback y, so that L = -feedback * (what is put out). States
/// outside of the loop count for stability where they grow; an integrator there does not.
Margins margins_of(const StateSpace& all, double feedback);

/// The frequency [rad/s] at which the gain first falls below 1/sqrt(2) of what it is at rest; infinite where
/// it never does, 0 where it is 0 or infinite at rest.
double bandwidth(const StateSpace& system);
/// The output at rest for an input of 1; infinite with a pole there.
double gain_at_rest(const StateSpace& system);

}  // namespace stepwire::linear
