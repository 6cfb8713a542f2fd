#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/analyse/statistics/power.hpp"

namespace stepwire::statistics {

/// How power is simulated.
struct PowerSimulation {
  std::uint64_t seed = 1;
  std::size_t experiments = 2000;
  std::size_t most_subjects = 200;
  double epsilon = 1.0;  ///< by which the degrees of freedom of F are corrected, above 0
};

/// The share of simulated experiments in which F of a term within subjects is significant at 0.05, by the
/// number of subjects (of none and one: 0). Each simulated subject is one of those seen, drawn with
/// replacement: the mean of scores[subject][contrast] stays the effect, what a subject deviates from it is
/// made larger by sqrt(n / (n - 1)), so that its variance is the one estimated. An experiment whose subjects
/// are all alike counts as not significant. One seed draws the same subjects for all terms. Empty for fewer
/// than three subjects and for scores that do not vary.
std::vector<double> simulated_power(const Eigen::MatrixXd& scores, const PowerSimulation& simulation = {});

/// The fewest subjects from which on the simulated power is what is wanted; nothing where that is beyond the
/// last one.
std::optional<std::size_t> subjects_needed(const std::vector<double>& by_subjects,
                                           double power = wanted_power);

}  // namespace stepwire::statistics
