#pragma once

#include <Eigen/Core>
#include <cstdint>
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
  Eigen::VectorXd start{}, whole{};         ///< states at the check, and one step later
  double least_growth = 1.1;                ///< factor per step of the slowest growth that is looked for
  double least_rate = 0.0;                  ///< smallest modulus of step times eigenvalue that grows so

  void prepare(const plan::Plan& plan);
};

/// Returns the next tick after `tick` at which the steps of a run are checked before its end; the last int64
/// if there is none. These are the quarters of the run. Parts that are switched and states that are reset can
/// hide what has grown. A plan with these is also checked at each eighth and at ticks 4, 8, 16, 32, ...
std::int64_t next_step_check(const plan::Plan& plan, std::int64_t tick);

/// Detects at the present tick that an explicit solver with fixed steps is unstable: states grow that the
/// equations damp. Writes the result into the report of steps and leaves the run unchanged.
///
/// A mode is unstable if it is a tenth of a state or more, the method would double it within the length of
/// the run, and the equations damp it. Further steps must confirm the growth. With more than 64 states only
/// growth by a tenth a step is looked for. Sizes are relative to each state, down to 1e-9 of its SI unit.
/// Growth that the equations themselves or a sampled controller cause is accepted.
///
/// Cheap tests go before: the derivatives of an unstable mode are large for the step, and one step differs
/// from two half steps. Only then the eigenvalues of the Jacobian are inserted into the stability function of
/// the method, and memory is allocated. Plans with error control or with more than 400 states are not
/// checked.
void find_unstable_steps(BoundBlocks& blocks, Stepper& stepper, StepProbeMemory& memory);

}  // namespace stepwire::run
