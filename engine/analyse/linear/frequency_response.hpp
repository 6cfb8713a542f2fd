#pragma once

#include <array>
#include <vector>

#include "engine/analyse/linear/point_response.hpp"
#include "engine/analyse/linear/poles.hpp"
#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// One input to one output at single frequencies: s = j w, or z = exp(j w T).
class FrequencyResponse {
 public:
  explicit FrequencyResponse(const StateSpace& system);

  Complex at(double frequency) const;  ///< [rad/s]

  /// Frequencies [rad/s] that show all there is: two decades beyond poles and zeros, closer about each of
  /// them, and up to half of the sample frequency. With delays, which turn the phase without end, one decade
  /// beyond, or for 12 rad, in steps that show each turn.
  std::vector<double> frequencies(std::size_t per_decade = 200) const;
  /// The first and the last of them.
  std::array<double, 2> range() const;
  /// Up to there turns of all delays are followed [rad/s]; infinite without delays.
  double last_followed() const;
  /// The same as frequencies(), and so far beyond both ends that the gain has left 1 for good: no crossing of
  /// 1 is outside.
  std::vector<double> frequencies_across_one(std::size_t per_decade = 200) const;
  /// The output at rest for an input of 1; infinite with a pole there.
  double at_rest() const;

 private:
  void add_turns(double first, double last, std::vector<double>& frequencies) const;
  bool may_cross_beyond(double frequency, double decade) const;

  PointResponse response_;
  double sample_time_ = 0.0, delay_ = 0.0;  ///< [s]; the second one is the sum of all delays
  std::vector<Mode> corners_;               ///< poles and zeros
};

}  // namespace stepwire::linear
