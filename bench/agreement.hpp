#pragma once

namespace stepwire {

/// Steps every workload by every method and compares the states with the reference values, to a relative
/// error of 1e-11. Prints the deviations. Returns true if there is none.
bool results_agree();

}  // namespace stepwire
