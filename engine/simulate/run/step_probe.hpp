#pragma once

#include "engine/simulate/run/stepper.hpp"

namespace stepwire::run {

/// Detects, at the end of a run, that an explicit solver with fixed steps was unstable: states grew that the
/// equations damp. Writes the result into the report of steps and leaves the run unchanged.
///
/// The check needs a state above 1000 in its SI unit. First one step is compared with two half steps. If they
/// differ by a tenth, the eigenvalues of the Jacobian are inserted into the stability function of the method.
/// A mode is unstable if the method amplifies it, the equations do not, and further steps confirm the growth.
/// Growth that the equations themselves or a sampled controller cause is accepted. The usual run costs one
/// pass over its states; a Jacobian is evaluated only after the comparison fails.
void find_unstable_steps(BoundBlocks& blocks, Stepper& stepper);

}  // namespace stepwire::run
