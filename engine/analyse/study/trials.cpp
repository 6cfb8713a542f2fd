#include "engine/analyse/study/trials.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "engine/base/table/table_file.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::study {
namespace {

const std::array<const char*, 3> word_columns{"subject", "task", "condition"};

/// Splits the rows of a table into trials.
class TrialReader {
 public:
  explicit TrialReader(const std::string& path) : path_(path) {
    for (const char* name : word_columns) words_[name] = {};
    table_ = table::read_csv(path, words_);
    if (table_.rows() == 0)
      throw table::TableError(fmt::format("{}: there are no rows below the header", path));
  }

  std::vector<Trial> read() {
    for (const char* name : word_columns) check_words(name);
    const auto time = in_si("time", {{0, 0, 1}}, "s"), x = in_si("x", {{1}}, "mm"),
               y = in_si("y", {{1}}, "mm");
    for (std::size_t first = 0; first < table_.rows();) {
      std::size_t end = first + 1;
      while (end < table_.rows() && same_trial(first, end)) ++end;
      add(first, end, time, x, y);
      first = end;
    }
    return std::move(trials_);
  }

 private:
  [[noreturn]] void fail(std::size_t row, const std::string& message) const {
    throw table::TableError(fmt::format("{}:{}: {}", path_, row + 2, message));
  }

  const table::Column& column(const std::string& name) const {
    if (const table::Column* found = table_.find(name)) return *found;
    throw table::TableError(
        fmt::format("{}:1: there is no column '{}'; trials have subject, task, condition, time [s], "
                    "x [mm], y [mm]",
                    path_, name));
  }

  const std::string& word(const std::string& name, std::size_t row) const {
    return words_.at(name)[static_cast<std::size_t>(column(name).values[row])];
  }

  void check_words(const std::string& name) const {
    for (std::size_t row = 0; row < column(name).values.size(); ++row)
      if (word(name, row).empty()) fail(row, fmt::format("the {} is missing", name));
  }

  std::vector<double> in_si(const std::string& name, const unit::Dimension& dimension,
                            const char* usual) const {
    const table::Column& source = column(name);
    const auto unit = unit::parse_unit(source.unit);
    if (source.unit.empty() || !unit || unit->dimension != dimension)
      throw table::TableError(fmt::format("{}:1: the column '{}' needs a unit: '{} [{}]', not '{}'", path_,
                                          name, name, usual, source.unit));
    std::vector<double> values;
    for (std::size_t row = 0; row < source.values.size(); ++row) {
      if (!std::isfinite(source.values[row])) fail(row, fmt::format("'{}' is no finite number", name));
      values.push_back(unit->to_si(source.values[row]));
    }
    return values;
  }

  bool same_trial(std::size_t a, std::size_t b) const {
    for (const char* name : word_columns)
      if (column(name).values[a] != column(name).values[b]) return false;
    return true;
  }

  void add(std::size_t first, std::size_t end, const std::vector<double>& time, const std::vector<double>& x,
           const std::vector<double>& y) {
    Trial trial{word("subject", first), word("task", first), word("condition", first), {}, {}};
    const std::string name =
        fmt::format("subject {}, task {}, condition {}", trial.subject, trial.task, trial.condition);
    const auto [seen, is_new] = lines_.emplace(name, first + 2);
    if (!is_new)
      fail(first,
           fmt::format("{} starts again; its first trial is at line {}, and a repeated trial replaces the "
                       "first one",
                       name, seen->second));
    if (end - first < 2) fail(first, fmt::format("{} has one row only; a trial needs two or more", name));
    trial.points.resize(2, static_cast<Eigen::Index>(end - first));
    for (std::size_t row = first; row < end; ++row) {
      if (row > first && !(time[row] > time[row - 1]))
        fail(row, fmt::format("the time does not rise: {} s after {} s", time[row], time[row - 1]));
      trial.time.push_back(time[row]);
      trial.points.col(static_cast<Eigen::Index>(row - first)) << x[row], y[row];
    }
    trials_.push_back(std::move(trial));
  }

  const std::string& path_;
  table::ColumnWords words_;
  table::Table table_;
  std::map<std::string, std::size_t> lines_;  ///< Line at which each trial starts.
  std::vector<Trial> trials_;
};

/// Returns the table of such a file without rows.
table::Table table_of_trials(const std::vector<table::Column>& of_trials) {
  table::Table table;
  for (const char* name : word_columns) table.columns.push_back({name, "", {}});
  table.columns.push_back({"time", "s", {}});
  for (const char* name : {"x", "y"}) table.columns.push_back({name, "mm", {}});
  for (const table::Column& column : of_trials) table.columns.push_back({column.name, column.unit, {}});
  return table;
}

}  // namespace

std::vector<Trial> read_trials(const std::string& path) {
  return TrialReader(path).read();
}

std::string trials_csv(const std::vector<Trial>& trials, const std::vector<table::Column>& of_trials) {
  table::Table table = table_of_trials(of_trials);
  table::ColumnWords words;
  const unit::Unit millimetre = *unit::parse_unit("mm");
  for (std::size_t number = 0; number < trials.size(); ++number) {
    const Trial& trial = trials[number];
    const std::array<std::string, 3> names{trial.subject, trial.task, trial.condition};
    for (std::size_t row = 0; row < trial.time.size(); ++row) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (row == 0) words[word_columns[i]].push_back(names[i]);
        table.columns[i].values.push_back(static_cast<double>(words[word_columns[i]].size() - 1));
      }
      const Eigen::Vector2d point = trial.points.col(static_cast<Eigen::Index>(row));
      table.columns[3].values.push_back(trial.time[row]);
      table.columns[4].values.push_back(millimetre.from_si(point.x()));
      table.columns[5].values.push_back(millimetre.from_si(point.y()));
      for (std::size_t i = 0; i < of_trials.size(); ++i)
        table.columns[6 + i].values.push_back(of_trials[i].values[number]);
    }
  }
  return table::csv_text(table, words);
}

}  // namespace stepwire::study
