#pragma once

#include <cstddef>
#include <optional>

namespace stepwire::statistics {

/// Usual target of the power of a study (Cohen 1988).
inline constexpr double wanted_power = 0.8;

/// Returns the power of the two-sided paired t test at 0.05 with this number of subjects (2 or more) for the
/// effect d_z. It is the probability of both tails of the noncentral t. Nan for a d_z of nan.
double paired_power(double d_z, std::size_t subjects);

/// Returns the fewest subjects with the given power; std::nullopt if `most` are not enough.
std::optional<std::size_t> subjects_needed(double d_z, double power = wanted_power, std::size_t most = 10000);

}  // namespace stepwire::statistics
