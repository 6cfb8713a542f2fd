#pragma once

namespace stepwire {

/// Steps every workload by every means and compares with the reference values: at most 1e-11 apart,
/// relatively. Prints what is not.
bool results_agree();

}  // namespace stepwire
