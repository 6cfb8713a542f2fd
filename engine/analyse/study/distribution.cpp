#include "engine/analyse/study/distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/analyse/study/published.hpp"
#include "engine/analyse/study/side_by_side.hpp"

namespace stepwire::study {
namespace {

using Outcomes = std::vector<ExperimentOutcome>;

std::string name_of(const char* start, std::string factor) {
  std::ranges::replace(factor, ' ', '_');
  return start + factor;
}

/// Returns the finite values of a quantity over the experiments.
template <class Value>
std::vector<double> values_in(const Outcomes& experiments, Value value) {
  std::vector<double> values;
  for (const ExperimentOutcome& one : experiments)
    if (const double found = value(one.values); std::isfinite(found)) values.push_back(found);
  return values;
}

void add(std::string name, double published, std::vector<double> values, std::vector<Distribution>& all) {
  const bool known = std::ranges::find(all, name, &Distribution::name) != all.end();
  if (!known && !values.empty()) all.push_back({std::move(name), published, std::move(values)});
}

/// Adds the published values, then other values of the experiments whose names begin with `start`.
void add_values(const std::string& start, const std::vector<NamedValue>& published,
                const Outcomes& experiments, std::vector<Distribution>& all) {
  const auto add_value = [&](const std::string& name, double value) {
    add(name, value, values_in(experiments, [&](const auto& values) { return value_of(values, name); }), all);
  };
  for (const NamedValue& one : published) add_value(name_of(start.c_str(), one.name), one.value);
  if (experiments.empty()) return;
  for (const NamedValue& one : experiments.front().values)
    if (one.name.starts_with(start)) add_value(one.name, std::numeric_limits<double>::quiet_NaN());
}

void add_ratio(const std::string& of, const std::string& over, const Outcomes& experiments,
               const std::vector<NamedValue>& published, std::vector<Distribution>& all) {
  add(of + "/" + over, value_of(published, of) / value_of(published, over),
      values_in(experiments,
                [&](const auto& values) {
                  return value_of(values, "mean." + of) / value_of(values, "mean." + over);
                }),
      all);
}

/// Returns the cells of a line: "0.114", "0.0972", "0.0469", "0.194", "70.0 %".
std::vector<std::string> line_of(const Distribution& one) {
  std::vector<double> values = one.values;
  std::ranges::sort(values);
  const auto below = std::ranges::lower_bound(values, one.published) - values.begin();
  std::vector<std::string> line{one.name, printed_probability(one.published)};
  for (const double p : {0.5, 0.05, 0.95})
    line.push_back(printed_probability(statistics::hazen_quantile(values, p)));
  line.push_back(std::isnan(one.published) ? "–"
                                           : fmt::format("{:.1f} %", 100.0 * static_cast<double>(below) /
                                                                         static_cast<double>(values.size())));
  return line;
}

text::TextTable table_of(const char* of, const std::vector<Distribution>& all, const Outcomes& experiments,
                         const StudyRequest& request) {
  text::TextTable table{fmt::format("Task {}: {} in {} experiment{}", request.task, of, experiments.size(),
                                    experiments.size() == 1 ? "" : "s"),
                        {"value", "published", "median", "from (5 %)", "to (95 %)", "below the published"},
                        {},
                        {}};
  for (const Distribution& one : all) table.rows.push_back(line_of(one));
  return table;
}

/// Returns the number of experiments in which a factor is significant and its effect has this sign: 1 raises
/// the error, -1 lowers it.
std::string significant_in(const Outcomes& experiments, const std::string& factor, double sign) {
  const auto count = std::ranges::count_if(experiments, [&](const ExperimentOutcome& one) {
    return value_of(one.values, name_of("p.", factor)) < significant &&
           sign * value_of(one.values, name_of("effect.", factor)) > 0.0;
  });
  return fmt::format("{} of {}", count, experiments.size());
}

}  // namespace

std::vector<Distribution> distributions_of_errors(const Outcomes& experiments, const StudyRequest& request) {
  const std::vector<NamedValue>& means = request.published.means.values;
  std::vector<Distribution> all;
  add_values("mean.", means, experiments, all);
  for (const auto& order : request.published.order)
    for (std::size_t i = 1; i < order.size(); ++i) {
      add_ratio(order[i], order[i - 1], experiments, means, all);
      add_ratio(order[i], order[0], experiments, means, all);
    }
  return all;
}

std::vector<Distribution> distributions_of_p(const Outcomes& experiments, const StudyRequest& request) {
  std::vector<Distribution> all;
  add_values("p.", request.published.probabilities.values, experiments, all);
  return all;
}

text::TextTable experiments_table(const Outcomes& experiments, const StudyRequest& request) {
  text::TextTable table =
      table_of("mean errors", distributions_of_errors(experiments, request), experiments, request);
  table.notes = {"Each experiment has other people and other noise."};
  return table;
}

text::TextTable experiments_significance_table(const Outcomes& experiments, const StudyRequest& request) {
  text::TextTable table =
      table_of("significance (P)", distributions_of_p(experiments, request), experiments, request);
  table.columns.insert(table.columns.end(), {"lowers the error", "raises it"});
  for (auto& row : table.rows)
    for (const double sign : {-1.0, 1.0})
      row.push_back(significant_in(experiments, row.front().substr(2), sign));
  table.notes = {
      fmt::format("Lowers, raises: in how many experiments P is below {} and the feedback lowers or "
                  "raises the mean error beside the others.",
                  significant)};
  return table;
}

}  // namespace stepwire::study
