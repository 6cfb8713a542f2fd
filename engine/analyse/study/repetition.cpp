#include "engine/analyse/study/repetition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/statistics/quartiles.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire {

std::vector<NamedValue> published_outcome(const StudyRequest& request) {
  const PublishedStudy& study = request.published;
  std::vector<NamedValue> values;
  for (const NamedValue& mean : study.means.values) values.push_back({"mean." + mean.name, mean.value});
  for (const NamedValue& p : study.probabilities.values) {
    std::string name = "p." + p.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    values.push_back({name, p.value});
  }
  for (const std::string& condition : request.condition_names())
    if (study.means.values.empty())
      values.push_back({"mean." + condition, std::numeric_limits<double>::quiet_NaN()});
  return values;
}

void Repetition::read(const std::string& path) {
  const Table table = read_csv(path);
  const auto fits = [&] {
    if (table.columns.size() != columns_.size() + 1 || table.columns.front().name != "seed") return false;
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (table.columns[i + 1].name != columns_[i]) return false;
    return true;
  };
  if (!fits())
    throw TableError(fmt::format("{}:1: these are no experiments of this study, whose columns are seed, {}",
                                 path, fmt::join(columns_, ", ")));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::vector<double> values;
    for (std::size_t i = 0; i < columns_.size(); ++i) values.push_back(table.columns[i + 1].values[row]);
    rows_[static_cast<std::uint64_t>(table.columns.front().values[row])] = std::move(values);
  }
}

std::string Repetition::csv() const {
  Table table{{{"seed", "", {}}}};
  for (const std::string& name : columns_) table.columns.push_back({name, "", column(name)});
  for (const auto& [seed, values] : rows_) table.columns.front().values.push_back(static_cast<double>(seed));
  return csv_text(table);
}

void Repetition::add(std::uint64_t seed, const std::vector<NamedValue>& outcome) {
  std::vector<double> values;
  for (const NamedValue& value : outcome) values.push_back(value.value);
  rows_[seed] = std::move(values);
}

std::vector<double> Repetition::column(const std::string& name) const {
  const auto index =
      static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), name) - columns_.begin());
  std::vector<double> values;
  for (const auto& [seed, row] : rows_)
    values.push_back(index < row.size() ? row[index] : std::numeric_limits<double>::quiet_NaN());
  return values;
}

TextTable Repetition::table(const StudyRequest& request) const {
  TextTable table{fmt::format("Task {} in {} simulated experiments", request.task, rows_.size()),
                  {"value", "thesis", "median", "from (5 %)", "to (95 %)", "below the thesis'"},
                  {},
                  {}};
  for (const NamedValue& published : published_outcome(request)) {
    std::vector<double> values = column(published.name);
    std::erase_if(values, [](double value) { return std::isnan(value); });
    if (values.empty()) continue;
    std::sort(values.begin(), values.end());
    const auto below = std::lower_bound(values.begin(), values.end(), published.value) - values.begin();
    table.rows.push_back({published.name, printed_probability(published.value)});
    for (const double p : {0.5, 0.05, 0.95})
      table.rows.back().push_back(printed_probability(hazen_quantile(values, p)));
    table.rows.back().push_back(
        std::isnan(published.value) ? "–" : fmt::format("{:.1f} %", 100.0 * static_cast<double>(below) / static_cast<double>(values.size())));
  }
  return table;
}

}  // namespace stepwire
