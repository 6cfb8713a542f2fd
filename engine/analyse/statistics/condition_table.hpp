#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/analyse/statistics/observations.hpp"

namespace stepwire::statistics {

/// Observations of the subjects with a value under every condition, also as a table.
struct ConditionTable {
  std::vector<std::string> subjects, conditions;
  Eigen::MatrixXd values;  ///< [subject][condition]; several values of a subject are averaged.
  Observations observations;
  std::vector<std::string> left_out;  ///< Messages such as "subject 10 has no value under HV".

  std::vector<double> column(std::size_t condition) const;
  std::vector<double> differences(
      std::size_t first, std::size_t second) const;  ///< Differences, with those below rounding set to 0.
};

/// Builds the table. The conditions are the levels of a factor, in the given order of names. Conditions
/// without any value are left out first, then subjects with a missing condition. Throws StatisticsError if
/// fewer than two conditions or two subjects remain, and for the faults of Observations::check.
ConditionTable condition_table(const Observations& observations, const std::string& condition,
                               const std::string& subject, const std::vector<std::string>& order);

}  // namespace stepwire::statistics
