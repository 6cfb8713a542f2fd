#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

namespace stepwire::linear {

using Complex = std::complex<double>;

/// A row or column of a state space: one element of a state, an input or an output.
struct Channel {
  std::string name;  ///< "cart.x", of a vector "plant.x.2"
  std::string unit;  ///< SI; empty where none is known or it has none
};

/// A delay within a system: what goes out at an output of its own comes in at an input of its own later.
struct InnerDelay {
  double time = 0.0;  ///< [s]
  Channel out, in;
};

/// dx/dt = A x + B u, y = C x + D u; with a sample time x[k+1] = A x[k] + B u[k], y[k] = C x[k] + D u[k].
/// Numbers are SI. Behind the inputs and outputs of the system lie those of its delays.
struct StateSpace {
  Eigen::MatrixXd A, B, C, D;
  std::vector<Channel> states, inputs, outputs;
  double sample_time = 0.0;          ///< [s]; 0: continuous
  std::vector<InnerDelay> delays{};  ///< of continuous systems alone

  bool is_sampled() const { return sample_time > 0.0; }
  bool has_one_channel() const { return inputs.size() == 1 && outputs.size() == 1; }
  /// Names of all columns of B, and of all rows of C.
  std::vector<Channel> all_inputs() const, all_outputs() const;
  /// One input to one output, with all states.
  StateSpace channel(std::size_t input, std::size_t output) const;
  /// Without the states and delays that no input reaches, or that reach no output: what is put out stays as
  /// it is.
  StateSpace connected() const;
  /// With u = feedback * y + new input, for one input and one output. Its matrices are not finite where the
  /// loop has no solution.
  StateSpace closed(double feedback) const;
};

}  // namespace stepwire::linear
