#pragma once

#include <cstddef>
#include <optional>

namespace stepwire::statistics {

/// The power that a study is to have, as laboratories plan it (Cohen 1988).
inline constexpr double wanted_power = 0.8;

/// Probability that the paired t test of so many subjects (2 or more) is significant at 0.05, two-sided,
/// where the effect is d_z: both tails of the noncentral t. Nan for a d_z of nan.
double paired_power(double d_z, std::size_t subjects);

/// The fewest subjects with the power that is wanted; nothing where `most` do not have it.
std::optional<std::size_t> subjects_needed(double d_z, double power = wanted_power, std::size_t most = 10000);

}  // namespace stepwire::statistics
