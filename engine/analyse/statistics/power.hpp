#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace stepwire::statistics {

/// Usual target of the power of a study (Cohen 1988).
inline constexpr double wanted_power = 0.8;

/// Returns the power of the two-sided paired t test at 0.05 with this number of subjects (2 or more) for the
/// effect d_z. It is the probability of both tails of the noncentral t. Nan for a d_z of nan.
double paired_power(double d_z, std::size_t subjects);

/// Returns the fewest subjects with the given power; std::nullopt if `most` are not enough.
std::optional<std::size_t> subjects_needed(double d_z, double power = wanted_power, std::size_t most = 10000);

/// Parameters of the simulation of power.
struct PowerSimulation {
  std::uint64_t seed = 1;
  std::size_t experiments = 2000;
  std::size_t most_subjects = 200;
  double epsilon = 1.0;  ///< Correction factor of the degrees of freedom of F, above 0.
};

/// Returns the simulated power of a within-subject term by the number of subjects (0 for none and one). Power
/// is the share of experiments in which F is significant at 0.05. Simulated subjects are drawn with
/// replacement from the rows of scores[subject][contrast]. The mean of the scores remains the effect.
/// Deviations from it are scaled by sqrt(n / (n - 1)), so that the population has the estimated variance. An
/// experiment with identical subjects is not significant. A seed draws the same subjects for all terms. Empty
/// for fewer than three subjects and for constant scores.
std::vector<double> simulated_power(const Eigen::MatrixXd& scores, const PowerSimulation& simulation = {});

/// Returns the fewest subjects from which on the simulated power is at least `power`; std::nullopt if the
/// last entry is below it.
std::optional<std::size_t> subjects_needed(const std::vector<double>& by_subjects,
                                           double power = wanted_power);

}  // namespace stepwire::statistics
