#pragma once

#include <vector>

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// The eigenvalues of a matrix: of each group of states that depend on each other by itself, so that chains
/// of delays have exact zeros. In the order of sort_by_size().
std::vector<Complex> eigenvalues(const Eigen::MatrixXd& A);

/// By size, of a pair the one above the real axis first.
void sort_by_size(std::vector<Complex>& values);

/// A pole and how it moves.
struct Mode {
  Complex pole;
  double frequency = 0.0;  ///< natural frequency [rad/s]
  double damping = 1.0;    ///< -1 to 1: cosine of its angle to the negative real axis, in the plane of s
};

/// The poles of a system; with delays, whose number has no end, those of delay_poles().
std::vector<Complex> poles_of(const StateSpace& system);
/// The modes of a system. A sampled pole z counts as s = log(z) / sample time; one at 0 has an infinite
/// frequency.
std::vector<Mode> modes_of(const StateSpace& system);

/// True with all poles to the left of the imaginary axis, or inside of the unit circle. Poles that poles_of()
/// leaves out count, too. One on the border (but for 1e-12 of the largest) does not. A system with
/// delays counts as unstable where that cannot be found out.
bool is_stable(const StateSpace& system);

/// The invariant zeros: where the system matrix loses rank; of a controllable and observable system its
/// transmission zeros. A. Emami-Naeini, P. Van Dooren, "Computation of zeros of linear multivariable
/// systems", 1982. None of a system with delays, which has zeros without end.
std::vector<Complex> zeros_of(const StateSpace& system);

}  // namespace stepwire::linear
