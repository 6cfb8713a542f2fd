#pragma once

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

}  // namespace stepwire::linear
