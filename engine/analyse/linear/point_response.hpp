#pragma once

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// The first output over the first input, C (s - A)^-1 B + D, at points of the plane of s or z. Each delay of
/// the system counts as exp(-s T).
class PointResponse {
 public:
  /// Reduces A once, so that each point costs n^2 (A. J. Laub, 1981).
  explicit PointResponse(const StateSpace& system);

  Complex at(const Complex& point) const;
  /// The gains between delays, times exp(-s T) of the delay at their end.
  Eigen::MatrixXcd around(const Complex& point) const;
  /// The determinant of 1 less around(), which is 0 at poles.
  Complex return_difference(const Complex& point) const;

 private:
  /// Of all outputs over all inputs, those of the delays behind the system's own.
  Eigen::MatrixXcd between(const Complex& point) const;
  Eigen::VectorXcd turned(const Complex& point) const;

  Eigen::MatrixXd hessenberg_, B_, C_, D_;
  std::vector<InnerDelay> delays_;
};

}  // namespace stepwire::linear
