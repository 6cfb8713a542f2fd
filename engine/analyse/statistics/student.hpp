#pragma once

namespace stepwire::statistics {

/// Returns the quantile of Student's t; 0 < probability < 1, `freedom` above 0.
double student_quantile(double probability, double freedom);

}  // namespace stepwire::statistics
