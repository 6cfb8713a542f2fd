#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/analyse/statistics/observations.hpp"

namespace stepwire::statistics {

/// The observations of those subjects who have a value under every condition, and the same as a table.
struct ConditionTable {
  std::vector<std::string> subjects, conditions;
  Eigen::MatrixXd values;  ///< [subject][condition]; several values of a subject count as their mean
  Observations observations;
  std::vector<std::string> left_out;  ///< "subject 10 has no value under HV", "nobody has a value under H"

  std::vector<double> column(std::size_t condition) const;
  std::vector<double> differences(std::size_t first, std::size_t second) const;  ///< without rounding
};

/// The conditions are levels of a factor, in an order of names; one that nobody has met is left out, and then
/// subjects who lack one. Throws StatisticsError where fewer than two conditions or two subjects are left,
/// and for what Observations::check refuses.
ConditionTable condition_table(const Observations& observations, const std::string& condition,
                               const std::string& subject, const std::vector<std::string>& order);

}  // namespace stepwire::statistics
