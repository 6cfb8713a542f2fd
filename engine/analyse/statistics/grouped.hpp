#pragma once

#include <Eigen/Core>

#include "engine/analyse/statistics/anova.hpp"

namespace stepwire::statistics {

/// Observations in groups with the same levels of all factors of a model. The model sees one row per group,
/// so its cost does not grow with the number of observations. The values are differences from the first one,
/// which keep the digits that a large mean would cost.
struct Grouped {
  Observations groups;    ///< One row per observed combination of levels; the values are the means.
  Eigen::VectorXd roots;  ///< Roots of the numbers of observations.
  double within = 0.0;    ///< Sum of squares about the means.
  double total = 0.0;     ///< Sum of squares about the mean of all.
  double count = 0.0;     ///< Number of observations.
};

/// Groups observations by the factors of some terms. Throws StatisticsError for an unknown factor.
Grouped grouped(const Observations& observations, const std::vector<Term>& terms);

}  // namespace stepwire::statistics
