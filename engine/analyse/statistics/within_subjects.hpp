#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"
#include "engine/analyse/statistics/assumptions.hpp"
#include "engine/analyse/statistics/condition_table.hpp"
#include "engine/analyse/statistics/paired_test.hpp"
#include "engine/analyse/statistics/power.hpp"

namespace stepwire::statistics {

/// 95 % confidence intervals of the mean of a condition.
struct MeanInterval {
  double mean = 0.0;
  ConfidenceInterval plain;  ///< Student's interval of the raw values.
  /// Within-subject interval: between-subject variance removed (Cousineau 2005), with Morey's (2008)
  /// correction for the number of conditions. Intervals of two conditions that do not overlap indicate a
  /// difference. Nan for a single condition.
  ConfidenceInterval within_subject;
};

/// Computes the intervals of each column of values[subject][condition]; needs two subjects or more.
std::vector<MeanInterval> mean_intervals(const Eigen::MatrixXd& values);

/// Comparison of two conditions of the same subjects, first minus second.
struct PairComparison {
  std::string first, second;
  PairedTest test;
  SignedRank ranks;
  double holm = 1.0;        ///< P of the t test corrected for the number of comparisons.
  double ranks_holm = 1.0;  ///< The same for the signed ranks.
  PairedEffect effect;
  std::optional<Normality> normality;  ///< Normality of the differences.
};

/// Statistics of within-subject conditions besides the analysis of variance.
struct WithinSubjects {
  ConditionTable table;
  std::vector<std::string> factors;         ///< Factors of the analysis of variance.
  std::vector<MeanInterval> means;          ///< Means of the conditions, in their order.
  std::vector<PairComparison> comparisons;  ///< Comparisons of all pairs, in the order of the conditions.
  Anova repeated;                           ///< Analysis of the subjects in the table.
  std::vector<TermEffect> effects;          ///< Effects of its terms.
  std::optional<Normality> residuals;       ///< Normality of the residuals of the model subject + condition.
  std::optional<VarianceTest> variances;
};

/// Compares the levels of the factor `condition`, in the given order of names. The terms of the analysis of
/// variance are those of `factors`. Throws StatisticsError for the faults of condition_table and
/// repeated_measures.
WithinSubjects within_subjects(const Observations& observations, const std::vector<std::string>& factors,
                               const std::vector<std::string>& order, const std::string& condition,
                               const std::string& subject);

/// Power of a comparison or a term, and the subjects needed for `wanted_power`. Missing values are nan and
/// std::nullopt.
struct PowerRow {
  std::string of;    ///< Name of the comparison or term: "NO - H", "haptic:visual".
  double d_z = 0.0;  ///< Effect size of a comparison or of a term with one degree of freedom.
  double power = 0.0,
         simulated = 0.0;  ///< Power at the present number of subjects: by the noncentral t, by simulation.
  std::optional<std::size_t> needed, needed_simulated;
  bool simulation_possible = false;  ///< True for three or more subjects with varying scores.
};

/// Returns the power of every comparison, then of every term.
std::vector<PowerRow> power_rows(const WithinSubjects& within, const PowerSimulation& simulation = {});

}  // namespace stepwire::statistics
