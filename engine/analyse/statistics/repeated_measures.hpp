#pragma once

#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"

namespace stepwire::statistics {

/// Computes a mixed analysis of variance. Every subject has met all combinations of the factors `within`, and
/// has one level of each factor `between`. A within-subject term and its interactions with `between` are
/// tested against its interaction with the subject. Between-subject terms are tested against the subjects of
/// equal levels. Groups may differ in size: sums of squares are partial (type III). Several values of a
/// subject in a cell are averaged. Within-subject terms of more than one degree of freedom have their
/// sphericity, from covariances pooled over the groups. A warning names the terms that violate it (epsilon
/// below 0.75, or Mauchly's P below 0.05). Throws StatisticsError for an incomplete design, with the first
/// missing subject and cell, and for fewer than two subjects.
Anova repeated_measures(const Observations& observations, const std::vector<std::string>& within,
                        const std::string& subject, const std::vector<std::string>& between = {});

}  // namespace stepwire::statistics
