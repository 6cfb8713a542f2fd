#include "engine/analyse/study/distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/quartiles.hpp"
#include "engine/analyse/study/published.hpp"
#include "engine/analyse/study/side_by_side.hpp"

namespace stepwire {

namespace {

using Outcomes = std::vector<ExperimentOutcome>;

std::string name_of(const char* start, std::string factor) {
  std::ranges::replace(factor, ' ', '_');
  return start + factor;
}

/// The finite ones of what each experiment gives.
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

void add_ratio(const std::string& of, const std::string& over, const Outcomes& experiments,
               const std::vector<NamedValue>& published, std::vector<Distribution>& all) {
  add(of + "/" + over, value_of(published, of) / value_of(published, over),
      values_in(experiments,
                [&](const auto& values) {
                  return value_of(values, "mean." + of) / value_of(values, "mean." + over);
                }),
      all);
}

/// "0.114", "0.0972", "0.0469", "0.194", "70.0 %".
std::vector<std::string> line_of(const Distribution& one) {
  std::vector<double> values = one.values;
  std::ranges::sort(values);
  const auto below = std::ranges::lower_bound(values, one.published) - values.begin();
  std::vector<std::string> line{one.name, printed_probability(one.published)};
  for (const double p : {0.5, 0.05, 0.95}) line.push_back(printed_probability(hazen_quantile(values, p)));
  line.push_back(
      fmt::format("{:.1f} %", 100.0 * static_cast<double>(below) / static_cast<double>(values.size())));
  return line;
}

TextTable table_of(const char* of, const std::vector<Distribution>& all, const Outcomes& experiments,
                   const StudyRequest& request) {
  TextTable table{fmt::format("Task {}: {} in {} experiment{}", request.task, of, experiments.size(),
                              experiments.size() == 1 ? "" : "s"),
                  {"value", "thesis", "median", "from (5 %)", "to (95 %)", "below the thesis'"},
                  {},
                  {}};
  for (const Distribution& one : all) table.rows.push_back(line_of(one));
  return table;
}

/// In how many experiments a factor is significant and moves the error that way: 1 up, -1 down.
std::string significant_in(const Outcomes& experiments, const std::string& factor, double sign) {
  const auto count = std::ranges::count_if(experiments, [&](const ExperimentOutcome& one) {
    return value_of(one.values, name_of("p.", factor)) < significant &&
           sign * value_of(one.values, name_of("effect.", factor)) > 0.0;
  });
  return fmt::format("{} of {}", count, experiments.size());
}

}  // namespace

std::vector<Distribution> distributions_of_errors(const Outcomes& experiments, const StudyRequest& request) {
  const PublishedTask& task = published_task(request.task);
  std::vector<Distribution> all;
  for (const NamedValue& mean : task.means.values) {
    const std::string name = "mean." + mean.name;
    add(name, mean.value, values_in(experiments, [&](const auto& values) { return value_of(values, name); }),
        all);
  }
  for (const auto& order : task.order)
    for (std::size_t i = 1; i < order.size(); ++i) {
      add_ratio(order[i], order[i - 1], experiments, task.means.values, all);
      add_ratio(order[i], order[0], experiments, task.means.values, all);
    }
  return all;
}

std::vector<Distribution> distributions_of_p(const Outcomes& experiments, const StudyRequest& request) {
  std::vector<Distribution> all;
  for (const NamedValue& p : published_task(request.task).probabilities.values) {
    const std::string name = name_of("p.", p.name);
    add(name, p.value, values_in(experiments, [&](const auto& values) { return value_of(values, name); }),
        all);
  }
  return all;
}

TextTable experiments_table(const Outcomes& experiments, const StudyRequest& request) {
  TextTable table =
      table_of("mean errors", distributions_of_errors(experiments, request), experiments, request);
  table.notes = {"Each experiment has other people and other noise."};
  return table;
}

TextTable experiments_significance_table(const Outcomes& experiments, const StudyRequest& request) {
  TextTable table =
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

}  // namespace stepwire
