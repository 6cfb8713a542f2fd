// Power of the comparisons and terms within subjects.
#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/statistics/contrasts.hpp"
#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/within_subjects.hpp"

namespace stepwire::statistics {
namespace {

PowerRow power_of(const std::string& name, const Eigen::MatrixXd& scores, const PowerSimulation& simulation) {
  const auto subjects = static_cast<std::size_t>(scores.rows());
  PowerRow row{name, no_number, no_number, no_number, {}, {}, false};
  if (scores.cols() == 1) {
    const PairedTest test = paired_test({scores.data(), scores.data() + scores.size()});
    row.d_z = test.deviation > 0.0 ? test.mean / test.deviation : no_number;
    row.power = paired_power(row.d_z, subjects);
    row.needed = subjects_needed(row.d_z);
  }
  const auto simulated = simulated_power(scores, simulation);
  if (subjects < simulated.size()) row.simulated = simulated[subjects];
  row.simulation_possible = !simulated.empty();
  row.needed_simulated = subjects_needed(simulated);
  return row;
}

/// Returns the factors in the name of a term: "haptic:visual".
std::vector<std::string> factors_in(const std::string& term) {
  std::vector<std::string> factors;
  for (std::size_t from = 0, to = 0; to != std::string::npos; from = to + 1) {
    to = term.find(':', from);
    factors.push_back(term.substr(from, to - from));
  }
  return factors;
}

std::string subject_of(const Observations& observations) {
  for (const Factor& factor : observations.factors)
    if (factor.subject) return factor.name;
  return "subject";
}

}  // namespace

std::vector<PowerRow> power_rows(const WithinSubjects& within, const PowerSimulation& simulation) {
  std::vector<PowerRow> rows;
  for (const PairComparison& one : within.comparisons) {
    const auto& names = within.table.conditions;
    const auto at = [&](const std::string& name) {
      return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    const auto differences = within.table.differences(at(one.first), at(one.second));
    const Eigen::Map<const Eigen::VectorXd> scores(differences.data(),
                                                   static_cast<Eigen::Index>(differences.size()));
    rows.push_back(power_of(fmt::format("{} - {}", one.first, one.second), scores, simulation));
  }
  const Observations& observations = within.table.observations;
  const Eigen::MatrixXd means = cell_means(observations, within.factors, subject_of(observations));
  for (const TermEffect& effect : within.effects) {
    PowerSimulation corrected = simulation;
    if (const auto& sphericity = within.repeated.find(effect.term)->sphericity)
      corrected.epsilon = sphericity->epsilon;
    const Eigen::MatrixXd scores =
        means * contrasts_of(factors_in(effect.term), observations, within.factors);
    rows.push_back(power_of(effect.term, scores, corrected));
  }
  return rows;
}

}  // namespace stepwire::statistics
