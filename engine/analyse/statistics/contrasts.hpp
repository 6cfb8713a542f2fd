#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"

namespace stepwire::statistics {

/// Returns the cell means: a row per subject, a column per combination of the factors, the last factor
/// varying fastest. Throws StatisticsError if a subject has no value in a cell.
Eigen::MatrixXd cell_means(const Observations& observations, std::vector<std::string> factors,
                           const std::string& subject);

/// Returns the orthonormal contrasts of a term between these columns, one per column.
Eigen::MatrixXd contrasts_of(const std::vector<std::string>& term, const Observations& observations,
                             const std::vector<std::string>& factors);

}  // namespace stepwire::statistics
