#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/statistics/independent_pairs.hpp"
#include "engine/analyse/statistics/within_subjects.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/text/text_table.hpp"

namespace stepwire::study {

/// The columns of a table of scores and the model that explains them.
struct ScoresRequest {
  std::string score{};                 ///< Column of the scores; empty: the last one.
  std::vector<std::string> factors{};  ///< Columns of the factors; empty: all others but the subject.
  std::string subject{};               ///< Column of the subjects; empty: all scores are independent.
  bool additive = false;               ///< Main effects without interactions, of independent scores.
  statistics::SumsOfSquares sums = statistics::SumsOfSquares::partial;  ///< Of independent scores.
  std::optional<std::uint64_t> power_seed{};  ///< Seed of simulated power; none: no power.
};

/// Analysis of the scores of a table.
struct ScoresAnalysis {
  ScoresRequest request;  ///< with the columns that were taken
  statistics::Observations observations;
  std::vector<std::string> between, within;  ///< factors that are constant for each subject, and the others
  std::vector<std::string> left_out;         ///< subjects who miss a cell
  statistics::Anova anova;
  std::optional<statistics::WithinSubjects> pairs;    ///< comparisons of conditions within subjects
  std::vector<statistics::IndependentPair> groups{};  ///< comparisons of independent scores, if not too many
};

/// Reads a CSV file of a score a row and analyses it. Independent scores: factors of any number of levels
/// with all their interactions. With subjects: repeated measures, where a factor that is constant for each
/// subject is one between subjects. Throws TableError with the file for what cannot be read or analysed.
ScoresAnalysis analyse_scores(const std::string& path, ScoresRequest request);

/// Means of the cells, the analysis of variance, and comparisons of conditions.
std::vector<text::TextTable> score_tables(const ScoresAnalysis& analysis);

/// The same for programs; what does not exist is null.
json::Json scores_json(const std::string& path, const ScoresAnalysis& analysis);

}  // namespace stepwire::study
