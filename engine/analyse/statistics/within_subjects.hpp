#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/statistics/anova.hpp"
#include "engine/analyse/statistics/condition_table.hpp"
#include "engine/analyse/statistics/effect_size.hpp"
#include "engine/analyse/statistics/equal_variances.hpp"
#include "engine/analyse/statistics/mean_interval.hpp"
#include "engine/analyse/statistics/paired_test.hpp"
#include "engine/analyse/statistics/shapiro_wilk.hpp"
#include "engine/analyse/statistics/signed_rank.hpp"
#include "engine/analyse/statistics/simulated_power.hpp"

namespace stepwire::statistics {

/// Two conditions that the same subjects have met, first minus second.
struct PairComparison {
  std::string first, second;
  PairedTest test;
  SignedRank ranks;
  double holm = 1.0;        ///< P of the t test corrected for the number of comparisons
  double ranks_holm = 1.0;  ///< the same of the signed ranks
  PairedEffect effect;
  std::optional<Normality> normality;  ///< of the differences
};

/// What a laboratory reports of conditions within subjects beside the analysis of variance.
struct WithinSubjects {
  ConditionTable table;
  std::vector<std::string> factors;         ///< of the analysis of variance
  std::vector<MeanInterval> means;          ///< of the conditions, in their order
  std::vector<PairComparison> comparisons;  ///< of every pair, in the order of the conditions
  Anova repeated;                           ///< of the subjects in the table
  std::vector<TermEffect> effects;          ///< of its terms
  std::optional<Normality> residuals;       ///< of the model subject + condition
  std::optional<VarianceTest> variances;
};

/// Compares the levels of the factor `condition`, in an order of names; the terms of the analysis of variance
/// are those of `factors`. Throws StatisticsError for what condition_table and repeated_measures refuse.
WithinSubjects within_subjects(const Observations& observations, const std::vector<std::string>& factors,
                               const std::vector<std::string>& order, const std::string& condition,
                               const std::string& subject);

/// What power a comparison or a term has, and how many subjects it needs for `wanted_power`; nan and nothing
/// where that does not exist.
struct PowerRow {
  std::string of;                       ///< "NO - H", "haptic:visual"
  double d_z = 0.0;                     ///< of a comparison or a term of one degree of freedom
  double power = 0.0, simulated = 0.0;  ///< of as many subjects: by the noncentral t, by simulation
  std::optional<std::size_t> needed, needed_simulated;
  bool simulation_possible = false;  ///< three subjects or more whose scores vary
};

/// Of every comparison, then of every term.
std::vector<PowerRow> power_rows(const WithinSubjects& within, const PowerSimulation& simulation = {});

}  // namespace stepwire::statistics
