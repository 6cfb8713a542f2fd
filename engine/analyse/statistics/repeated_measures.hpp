#pragma once

#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"

namespace stepwire::statistics {

/// Analysis of variance of subjects who each met every combination of the factors `within`; of the factors
/// `between` each subject has one level. A term within subjects, and its interactions with those between, are
/// compared with its interaction with the subject; terms between subjects are compared with the subjects of
/// equal levels. Groups may differ in size: sums of squares are partial (type III). Several values of one
/// subject in one cell count as their mean. Terms of more than one degree of freedom within subjects carry
/// their sphericity, by the covariances pooled over the groups. A warning names those that lack it (epsilon
/// below 0.75, or Mauchly's P below 0.05). Throws StatisticsError where the design is not complete (it names
/// the first subject and cell that are missing), and for fewer than two subjects.
Anova repeated_measures(const Observations& observations, const std::vector<std::string>& within,
                        const std::string& subject, const std::vector<std::string>& between = {});

}  // namespace stepwire::statistics
