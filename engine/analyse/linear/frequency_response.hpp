#pragma once

#include <array>
#include <vector>

#include "engine/analyse/linear/poles.hpp"
#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// One input to one output at single frequencies: C (s - A)^-1 B + D, with s = j w, or z = exp(j w T).
class FrequencyResponse {
 public:
  /// Reduces A once, so that each frequency costs n^2 (A. J. Laub, 1981).
  explicit FrequencyResponse(const StateSpace& system);

  Complex at(double frequency) const;  ///< [rad/s]
  /// Anywhere in the plane of s, or of z.
  Complex at_point(const Complex& point) const;

  /// Frequencies [rad/s] that show all there is: two decades beyond poles and zeros, closer about each of
  /// them, and up to half of the sample frequency.
  std::vector<double> frequencies(std::size_t per_decade = 200) const;
  /// The first and the last of them.
  std::array<double, 2> range() const;
  /// The same, and so far beyond both ends that the gain has left 1 for good: no crossing of 1 is outside.
  std::vector<double> frequencies_across_one(std::size_t per_decade = 200) const;
  /// The output at rest for an input of 1; infinite with a pole there.
  double at_rest() const;

 private:
  bool may_cross_beyond(double frequency, double decade) const;

  Eigen::MatrixXd hessenberg_;
  Eigen::VectorXd B_;
  Eigen::RowVectorXd C_;
  double D_ = 0.0, sample_time_ = 0.0;
  std::vector<Mode> corners_;  ///< poles and zeros
};

}  // namespace stepwire::linear
