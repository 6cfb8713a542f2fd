#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/statistics/independent_pairs.hpp"
#include "engine/analyse/statistics/within_subjects.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/text/text_table.hpp"

namespace stepwire::study {

/// Columns of a table of scores, and the model for them.
struct ScoresRequest {
  std::string score{};                 ///< Column of the scores; empty: the last one.
  std::vector<std::string> factors{};  ///< Columns of the factors; empty: all others but the subject.
  std::string subject{};               ///< Column of the subjects; empty: all scores are independent.
  bool additive = false;               ///< True: main effects without interactions, for independent scores.
  statistics::SumsOfSquares sums = statistics::SumsOfSquares::partial;  ///< For independent scores.
  std::optional<std::uint64_t> power_seed{};  ///< Seed of simulated power; std::nullopt: no power.
};

/// Analysis of the scores of a table.
struct ScoresAnalysis {
  ScoresRequest request;  ///< Request with the defaults filled in.
  statistics::Observations observations;
  std::vector<std::string> between, within;  ///< Factors that are constant for each subject, and the others.
  std::vector<std::string> left_out;         ///< Subjects without a score in a cell.
  statistics::Anova anova;
  std::optional<statistics::WithinSubjects> pairs;    ///< Comparisons of conditions within subjects.
  std::vector<statistics::IndependentPair> groups{};  ///< Comparisons of independent scores, if not too many.
};

/// Analyses a CSV file with one score per row. Independent scores: an analysis of variance with all
/// interactions of the factors. With subjects: repeated measures, where a factor that is constant for each
/// subject is between subjects. Throws TableError with the file's name if it cannot be read or analysed.
ScoresAnalysis analyse_scores(const std::string& path, ScoresRequest request);

/// Returns the tables of cell means, of the analysis of variance, and of comparisons of conditions.
std::vector<text::TextTable> score_tables(const ScoresAnalysis& analysis);

/// Returns the analysis as JSON; missing values are null.
json::Json scores_json(const std::string& path, const ScoresAnalysis& analysis);

}  // namespace stepwire::study
