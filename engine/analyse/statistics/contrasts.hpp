#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"

namespace stepwire::statistics {

/// Means of the cells: a row for each subject, a column for each combination of the factors, the last one
/// running fastest. Throws StatisticsError where a subject has no value in a cell.
Eigen::MatrixXd cell_means(const Observations& observations, std::vector<std::string> factors,
                           const std::string& subject);

/// The orthonormal contrasts between these columns of which a term is made, a column for each.
Eigen::MatrixXd contrasts_of(const std::vector<std::string>& term, const Observations& observations,
                             const std::vector<std::string>& factors);

}  // namespace stepwire::statistics
