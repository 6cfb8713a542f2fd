#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "engine/simulate/run/stepper.hpp"
#include "engine/simulate/solve/tableau.hpp"

namespace stepwire::run {

/// Memory of the check below. A run that may not allocate at its end prepares it before.
struct StepProbeMemory {
  bool ready = false;
  std::optional<solve::Tableau> tableau{};  ///< std::nullopt for a plan that is not checked
  std::vector<double> kept{};               ///< copy of the whole workspace
  Eigen::VectorXd start{}, whole{};         ///< states at the end of the run, and one step later

  void prepare(const plan::Plan& plan);
};

/// Detects, at the end of a run, that an explicit solver with fixed steps was unstable: states grew that the
/// equations damp. Writes the result into the report of steps and leaves the run unchanged.
///
/// First one step is compared with two half steps. If they differ by a tenth of a state, the eigenvalues of
/// the Jacobian are inserted into the stability function of the method. A mode is unstable if it is a tenth
/// of a state or more, the method amplifies it, the equations do not, and further steps confirm the growth.
/// Sizes are relative to each state, down to 1e-9 of its SI unit. Growth that the equations themselves or a
/// sampled controller cause is accepted. The usual run costs three steps. Only after the
/// comparison fails, a Jacobian is evaluated and memory is allocated. Plans with error control or with more
/// than 400 states are not checked.
void find_unstable_steps(BoundBlocks& blocks, Stepper& stepper, StepProbeMemory& memory);

}  // namespace stepwire::run
