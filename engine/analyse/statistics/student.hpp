#pragma once

namespace stepwire::statistics {

/// The value below which Student's t stays with a probability (0 to 1, both exclusive); `freedom` above 0 are
/// its degrees of freedom.
double student_quantile(double probability, double freedom);

}  // namespace stepwire::statistics
