#pragma once

#include <array>
#include <vector>

#include "engine/analyse/linear/point_response.hpp"
#include "engine/analyse/linear/poles.hpp"
#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// Response of one output to one input at single frequencies: s = j w, or z = exp(j w T).
class FrequencyResponse {
 public:
  explicit FrequencyResponse(const StateSpace& system);

  Complex at(double frequency) const;  ///< Returns the response at a frequency [rad/s].

  /// Returns the frequencies [rad/s] of a plot. They reach two decades beyond poles and zeros, are denser
  /// near each, and end at half the sample frequency. With delays, whose phase has no limit, they reach one
  /// decade beyond, or up to 12 rad of phase. Their step then resolves each turn.
  std::vector<double> frequencies(std::size_t per_decade = 200) const;
  /// Returns the first and the last of them.
  std::array<double, 2> range() const;
  /// Returns the frequency [rad/s] up to which the phase of all delays is resolved; infinite without delays.
  double last_followed() const;
  /// Returns frequencies() extended at both ends until the gain has left 1 for good, so that no crossing of 1
  /// is missed.
  std::vector<double> frequencies_across_one(std::size_t per_decade = 200) const;
  /// Returns the gain at rest; infinite for a pole there.
  double at_rest() const;

 private:
  void add_turns(double first, double last, std::vector<double>& frequencies) const;
  bool may_cross_beyond(double frequency, double decade) const;

  PointResponse response_;
  double sample_time_ = 0.0, delay_ = 0.0;  ///< In s; `delay_` is the sum of all delays.
  std::vector<Mode> corners_;               ///< Poles and zeros.
};

}  // namespace stepwire::linear
