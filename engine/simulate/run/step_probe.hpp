#pragma once

#include "engine/simulate/run/stepper.hpp"

namespace stepwire::run {

/// Finds, at the end of a run, whether an explicit solver with fixed steps has made states grow that the
/// equations let fade, and writes it into the report of steps. The run stays as it was.
///
/// Looks at states beyond a thousand, each in its SI unit. There takes a step whole and as two halves. Where
/// the results differ by a tenth, puts the eigenvalues of the equations into the stability function of the
/// method. A mode is wrong where the method lets it grow, the equations do not, and further steps agree.
/// Growth that the equations have themselves, or that a sampled controller causes, passes.
void find_unstable_steps(BoundBlocks& blocks, Stepper& stepper);

}  // namespace stepwire::run
