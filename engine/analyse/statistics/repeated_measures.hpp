#pragma once

#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"

namespace stepwire::statistics {

/// Analysis of variance within subjects: every subject met every combination of the factors `within`, and
/// each term is compared with its interaction with the subject. Several values of one subject in one cell
/// count as their mean. Terms of more than one degree of freedom carry their sphericity, and a warning says
/// where it does not hold (epsilon below 0.75, or Mauchly's P below 0.05). Throws StatisticsError where the
/// design is not complete (it names the first subject and cell that are missing), and for fewer than two
/// subjects.
Anova repeated_measures(const Observations& observations, const std::vector<std::string>& within,
                        const std::string& subject);

}  // namespace stepwire::statistics
