#include "engine/view/plot/linear_rows.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "engine/analyse/query/formula.hpp"
#include "engine/view/plot/gather.hpp"

namespace stepwire::plot {

namespace {

constexpr std::size_t most_labels = 8;
const std::string mark_of_analyses = ".margin.gain";

std::vector<std::string> analyses_of(const query::SymbolTable& names) {
  std::vector<std::string> all;
  for (const query::RecordedName& column : names.columns)
    if (column.name.ends_with(mark_of_analyses))
      all.push_back(column.name.substr(0, column.name.size() - mark_of_analyses.size()));
  return all;
}

/// Returns the swept parameters, in the units of the file.
std::vector<query::Series> swept_columns(const query::NamesReading& read) {
  std::vector<query::Series> all;
  for (const query::RecordedName& column : read.names.columns) {
    if (column.recording || column.name == "time") continue;
    yaml::Node name;
    name.kind = yaml::Node::Kind::scalar;
    name.text = column.name;
    if (auto series = read.series(name)) {
      show_as_written(*series, read.names);
      all.push_back(std::move(*series));
    }
  }
  return all;
}

void read_analysis(Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
  const std::string name = read.text(node);
  if (!read.names.find(name + mark_of_analyses))
    return read.fault(node.mark,
                      fmt::format("there is no linear analysis '{}'", name) +
                          yaml::nearest_or_all(name, analyses_of(read.names), "the section 'linear' has"));
  if (auto series = read.series(node)) panel.series["of"] = {std::move(*series)};
  for (query::Series& series : swept_columns(read)) panel.series["of"].push_back(std::move(series));
}

}  // namespace

PanelKey analysis_key() {
  return yaml::needed(PanelKey{"of", "an analysis, by its name in the section `linear`", yaml::form::string(),
                               read_analysis});
}

LinearRows::LinearRows(const Panel& panel, std::span<const record::Recording> recordings) : panel_(panel) {
  const query::Series* of = panel.find("of");
  if (!of || panel.recordings.empty() || panel.recordings.front() >= recordings.size()) return;
  recording_ = &recordings[panel.recordings.front()];
  name_ = of->formula.columns.front();
  if (!recording_->table.find(name_ + mark_of_analyses)) return;
  table_ = &recording_->table;
  const std::vector<double> where =
      panel.where ? query::evaluate(*panel.where, *recording_) : std::vector<double>(table_->rows(), 1.0);
  for (std::size_t run = 0; run < recording_->starts.size(); ++run)
    if (const std::size_t row = recording_->starts[run]; row < where.size())
      if (where[row] != 0.0 && !std::isnan(where[row])) runs_.push_back(run);
}

std::vector<double> LinearRows::list(const std::string& name, std::size_t run) const {
  const table::Column* column = table_ ? table_->find(name_ + "." + name) : nullptr;
  if (!column) return {};
  const auto begin = column->values.begin();
  const std::size_t next = runs_[run] + 1;
  const auto end = next < recording_->starts.size()
                       ? begin + static_cast<std::ptrdiff_t>(recording_->starts[next])
                       : column->values.end();
  std::vector<double> values(begin + static_cast<std::ptrdiff_t>(first_row(run)), end);
  if (!values.empty() && std::isnan(values.front())) return {};
  return values;
}

double LinearRows::number(const std::string& name, std::size_t run) const {
  const std::vector<double> values = list(name, run);
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values.front();
}

std::string LinearRows::label(std::size_t run) const {
  if (run < panel_.legend.size()) return panel_.legend[run];
  if (runs() < 2 || runs() > most_labels) return {};
  std::vector<std::string> texts;
  for (const query::Series& series : panel_.series.at("of")) {
    const table::Column* column = table_->find(series.formula.columns.front());
    if (&series == panel_.find("of") || !column) continue;
    const double value = series.unit.from_si(column->values[first_row(run)]);
    texts.push_back(labels_of(series, {value}, *recording_, true).front());
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace stepwire::plot
