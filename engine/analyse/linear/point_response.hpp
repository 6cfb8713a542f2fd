#pragma once

#include <optional>
#include <vector>

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// A sampled system without the states that only pass another state on, as those of a delay of many samples.
///
/// Such a state has one number in its row of A and none in that of B. So it is a factor z^-steps times the
/// state at the head of its chain. The response then needs the inverse of a matrix of the other states alone.
class SampledChains {
 public:
  explicit SampledChains(const StateSpace& system);

  /// Returns the number of states that are left out.
  std::size_t count() const { return count_; }
  /// Returns C (z - A)^-1 B + D.
  Eigen::MatrixXcd response(const Complex& z) const;

 private:
  /// State at the end of a chain, as far as other states and outputs read it.
  struct Tail {
    Eigen::Index head;  ///< among the states that are kept
    double steps;
    Eigen::VectorXd into_states, into_outputs;
  };

  Eigen::MatrixXd A_, B_, C_, D_;
  std::vector<Tail> tails_;
  std::size_t count_ = 0;
};

/// Returns the bound of a response without states: `direct` is D, with rows and columns of the delays.
double largest_gain(const Eigen::MatrixXd& direct);

/// Transfer function C (s - A)^-1 B + D of the first input and output, at points of the s or z plane. A delay
/// of the system has the factor exp(-s T).
class PointResponse {
 public:
  /// Reduces A once to Hessenberg form, so that each point costs n^2 (A. J. Laub, 1981), or a sampled system
  /// to the states beside its delays.
  explicit PointResponse(const StateSpace& system);

  Complex at(const Complex& point) const;
  /// Returns the loop gain of the delays: the gains between them, times exp(-s T) of the delay at the end.
  Eigen::MatrixXcd around(const Complex& point) const;
  /// Returns a bound of the gain for any phases of the delays; infinite if their loops have a gain of 1.
  double bound(const Complex& point) const;
  /// Returns det(1 - around()), which is 0 at poles.
  Complex return_difference(const Complex& point) const;

 private:
  /// Returns the response of all outputs to all inputs; the delays' ones follow the system's own.
  Eigen::MatrixXcd between(const Complex& point) const;
  Eigen::VectorXcd turned(const Complex& point) const;

  Eigen::MatrixXcd near_rest(const Complex& point) const;

  Eigen::MatrixXd hessenberg_, B_, C_, D_;
  StateSpace plain_;        ///< Balanced system before the reduction.
  double near_rest_ = 0.0;  ///< Size of the points at which it is used [1/s].
  std::vector<InnerDelay> delays_;
  std::optional<SampledChains> chains_;  ///< in the place of the matrices
};

}  // namespace stepwire::linear
