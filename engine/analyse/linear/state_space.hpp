#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

namespace stepwire::linear {

using Complex = std::complex<double>;

/// A row or column of a state space: one element of a state, an input or an output.
struct Channel {
  std::string name;  ///< Name: "cart.x", for a vector "plant.x.2".
  std::string unit;  ///< SI unit; empty if unknown or dimensionless.
};

/// A delay within a system, with its own output (into the delay) and input (out of the delay).
struct InnerDelay {
  double time = 0.0;  ///< Delay time [s].
  Channel out, in;
};

/// Linear system dx/dt = A x + B u, y = C x + D u. A sampled one is x[k+1] = A x[k] + B u[k], y[k] = C x[k] +
/// D u[k]. Numbers are SI. Columns and rows of the delays follow those of the inputs and outputs.
struct StateSpace {
  Eigen::MatrixXd A, B, C, D;
  std::vector<Channel> states, inputs, outputs;
  double sample_time = 0.0;          ///< In s; 0: continuous.
  std::vector<InnerDelay> delays{};  ///< For continuous systems only.

  bool is_sampled() const { return sample_time > 0.0; }
  bool has_one_channel() const { return inputs.size() == 1 && outputs.size() == 1; }
  /// Return the channels of all columns of B, and of all rows of C.
  std::vector<Channel> all_inputs() const, all_outputs() const;
  /// Returns the system of one input and one output, with all states.
  StateSpace channel(std::size_t input, std::size_t output) const;
  /// Returns the system without the states and delays that no input reaches or that reach no output. The
  /// response is unchanged.
  StateSpace connected() const;
  /// Returns the system under u = feedback * y + new input, for one input and one output. Its matrices are
  /// not finite if the algebraic loop has no solution.
  StateSpace closed(double feedback) const;
};

/// Returns powers of two that scale the states (x = scale z) so that rows and columns of A have similar
/// norms. Eigenvalues are unchanged. B. N. Parlett, C. Reinsch, "Balancing a matrix for calculation of
/// eigenvalues and eigenvectors", 1969.
Eigen::VectorXd balancing(Eigen::MatrixXd A);

/// Number of state directions that inputs control, or that outputs observe.
struct Rank {
  Eigen::Index rank = 0;
  /// Singular values of [B, A B, ..., A^(n-1) B], or of its dual, the largest first. States are scaled to the
  /// same reach from the inputs; time and channels are scaled to a largest number of 1.
  std::vector<double> singular_values{};
  bool certain =
      true;  ///< False where a decision of the staircase form is close to the error of the numbers.
};

/// Compute the rank by the staircase form, whose rank decisions do not depend on powers of A, nor on the
/// units of states, inputs and outputs.
Rank controllability(const StateSpace& system);
Rank observability(const StateSpace& system);

}  // namespace stepwire::linear
