#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "engine/analyse/linear/delay_system.hpp"
#include "engine/analyse/linear/point_response.hpp"
#include "engine/analyse/linear/poles.hpp"
#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// Returns the zero of a function between two points where it has different signs, by bisection.
double find_zero(const std::function<double(double)>& function, double low, double high);

/// A point of a curve.
struct CurvePoint {
  double x = 0.0, y = 0.0;
};

/// Returns the minimum of a function between two points, by Brent's method (R. P. Brent, "Algorithms for
/// Minimization without Derivatives", 1973). The function has one minimum there.
CurvePoint find_minimum(const std::function<double(double)>& function, double low, double high);

/// Response of one output to one input at single frequencies: s = j w, or z = exp(j w T).
class FrequencyResponse {
 public:
  explicit FrequencyResponse(const StateSpace& system);

  Complex at(double frequency) const;  ///< Returns the response at a frequency [rad/s].
  /// Returns a bound of the gain for any phases of the delays; infinite if a loop of delays has a gain of 1.
  double bound(double frequency) const;
  /// Returns the bound at infinite frequency: the gain of direct paths.
  double direct_gain() const { return std::abs(direct_); }
  /// Returns the gain of the direct path with its sign; in a chain of delays that of the chain.
  double direct_value() const { return direct_; }

  /// Returns the frequencies [rad/s] of a plot. They reach two decades beyond poles and zeros, are denser
  /// near each, and end at half the sample frequency. With delays, whose phase has no limit, they reach one
  /// decade beyond, or up to 12 rad of phase. Their step then resolves each turn.
  std::vector<double> frequencies(std::size_t per_decade = 200) const;
  /// Returns the first and the last of them.
  std::array<double, 2> range() const;
  /// Returns the frequency [rad/s] up to which the phase of all delays is resolved; infinite without delays.
  double last_followed() const;
  /// Returns the delay of a chain of delays in a continuous system [s], whose gain they do not change; else
  /// 0.
  double delay_of_chain() const { return chain_ ? delay_ : 0.0; }
  /// True if each turn of the delays that can decide a margin is resolved: without delays, or in a chain.
  bool follows_all_turns() const { return delay_ == 0.0 || chain_.has_value(); }
  /// Returns the frequencies of a search for crossings and for the least distance from -1. They are denser
  /// near the closed-loop poles as well, and extend at both ends until the gain has left 1 for good. Beyond
  /// last_followed() a chain of delays is resolved where its gain is nearest to 1.
  std::vector<double> search_frequencies(const std::vector<Mode>& closed) const;
  bool is_sampled() const { return sample_time_ > 0.0; }

 private:
  Complex plain(double frequency) const;
  std::array<double, 2> ends_of(const std::vector<Mode>& corners) const;
  std::array<double, 2> plain_range(const std::vector<Mode>& corners) const;
  std::vector<double> spread(double first, double last, std::size_t per_decade,
                             const std::vector<Mode>& corners) const;
  void extend(double from, double decade, std::vector<double>& frequencies) const;
  void add_turns(double first, double last, std::vector<double>& frequencies) const;
  void add_windows(std::vector<double>& frequencies) const;
  bool may_cross_beyond(double frequency, double decade) const;

  std::optional<DelayChain> chain_;
  PointResponse response_;                  ///< Of the chain without its delays, or of the system.
  double sample_time_ = 0.0, delay_ = 0.0;  ///< In s; `delay_` is the sum of all delays.
  double samples_ = 0.0;  ///< Poles of a sampled system beyond its zeros, each with the phase of a sample.
  double direct_ = 0.0;
  std::vector<Mode> corners_;  ///< Poles and zeros.
};

}  // namespace stepwire::linear
