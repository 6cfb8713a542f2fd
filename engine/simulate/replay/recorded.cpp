#include "engine/simulate/replay/recorded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <filesystem>

#include "engine/base/hdf5/hdf5_read.hpp"

namespace stepwire::replay {

namespace {

/// True for a text file, false for HDF5.
bool has_lines(const std::string& file) {
  return file.ends_with(".csv");
}

/// Throws TableError for columns of different lengths.
void require_equal_lengths(const Recorded& recorded) {
  for (const table::Column& column : recorded.table.columns)
    if (column.values.size() != recorded.table.rows())
      throw table::TableError(fmt::format("{}: {} has {} rows, and {} has {}", recorded.file, column.name,
                                          column.values.size(), recorded.table.columns.front().name,
                                          recorded.table.rows()));
}

std::string title(const table::Column& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

std::vector<std::string> titles(const plan::Plan& plan, const diagram::RecordRequest& request) {
  std::vector<std::string> result;
  for (const record::RecordedColumn& column : record::recorded_columns(plan, request))
    result.push_back(title({column.name, column.dimension ? unit::si_name(*column.dimension) : "", {}}));
  return result;
}

std::string path_of(const std::string& folder, std::size_t recording, const char* ending) {
  return (std::filesystem::path(folder) / io::numbered("signals", recording, ending)).string();
}

bool is_there(const std::string& path) {
  std::error_code none;
  return std::filesystem::exists(path, none);
}

/// Runs in one table, each from time 0.
class RunsOfText : public RecordedRuns {
 public:
  RunsOfText(const std::string& file, std::size_t recording, const RecordedSweep& sweep) : runs_(sweep.runs) {
    table::ColumnWords words;
    for (const std::string& parameter : sweep.swept) words[parameter];
    recorded_ = read_recorded(file, 1 + sweep.swept.size(), words);
    require_columns(recorded_, sweep.plan, sweep.plan.diagram.records[recording]);
  }

  RecordedRows next() override {
    const auto begin = recorded_.times().begin() + static_cast<std::ptrdiff_t>(first_);
    if (begin == recorded_.times().end()) return {&recorded_, first_, 0};
    return {&recorded_, first_,
            static_cast<std::size_t>(std::find(begin + 1, recorded_.times().end(), 0.0) - begin)};
  }

  void take(std::size_t rows) override { first_ += rows; }

  std::string left_over() override {
    if (first_ == recorded_.table.rows()) return "";
    return fmt::format("{}: there are more rows than the {} runs give", place_of_row(recorded_, first_),
                       runs_);
  }

 private:
  Recorded recorded_;
  std::size_t runs_, first_ = 0;
};

constexpr std::size_t numbers_at_once = 1'000'000, columns_at_once = 10'000;

/// Runs in groups of a file, "run-1", ....
class RunsOfGroups : public RecordedRuns {
 public:
  RunsOfGroups(std::string file, std::size_t recording, const RecordedSweep& sweep)
      : file_(std::move(file)),
        sweep_(sweep),
        request_(sweep.plan.diagram.records[recording]),
        columns_(record::recorded_columns(sweep.plan, request_).size()) {}

  RecordedRows next() override {
    if (ahead_.empty()) read();
    current_ = std::move(ahead_.front());
    ahead_.pop_front();
    if (current_.table.rows() > 0) require_columns(current_, sweep_.plan, request_);
    return {&current_, 0, current_.table.rows()};
  }

  void take(std::size_t rows) override {
    if (rows < current_.table.rows() && left_over_.empty())
      left_over_ = fmt::format("{}: there are {} rows, and none when it is replayed", current_.file,
                               current_.table.rows());
  }

  std::string left_over() override {
    if (!left_over_.empty() || group(sweep_.runs, 1).empty()) return left_over_;
    return fmt::format("{}/{}: there are more runs than the {} of the sweep", file_, name(sweep_.runs),
                       sweep_.runs);
  }

 private:
  std::string name(std::size_t run) const {
    const auto* numbers = sweep_.numbers;
    return fmt::format("run-{}", (numbers && run < numbers->size() ? (*numbers)[run] : run) + 1);
  }

  /// Reads all columns of `count` runs, as "run-1/time", ....
  std::vector<table::Column> group(std::size_t first, std::size_t count) const {
    std::vector<std::string> names;
    for (std::size_t run = first; run < first + count; ++run) names.push_back(name(run));
    return hdf5::read_hdf5_groups(file_, names).columns;
  }

  void read() {
    std::size_t numbers = 0;
    std::vector<table::Column> columns = group(next_, at_once_);
    auto column = columns.begin();
    for (std::size_t run = next_; run < next_ + at_once_; ++run) {
      ahead_.push_back(run_of(run, column, columns.end()));
      numbers += ahead_.back().table.rows() * columns_;
    }
    next_ += at_once_;
    const std::size_t each = numbers / at_once_ + 1,
                      most = columns_at_once / (sweep_.swept.size() + columns_) + 1;
    at_once_ = std::clamp<std::size_t>(numbers_at_once / each, 1, most);
  }

  /// Takes the columns of a run, beginning at `from`. In a run with rows the swept parameters are the first
  /// columns.
  Recorded run_of(std::size_t run, std::vector<table::Column>::iterator& from,
                  std::vector<table::Column>::iterator end) const {
    const std::string path = name(run) + "/";
    Recorded recorded{file_ + "/" + name(run), {}, 1, false};
    auto& columns = recorded.table.columns;
    for (; from != end && from->name.starts_with(path); ++from) {
      columns.push_back(std::move(*from));
      columns.back().name.erase(0, path.size());
    }
    const std::size_t swept = sweep_.swept.size();
    if (columns.size() == swept + columns_)
      columns.erase(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(swept));
    if (columns.empty()) columns.emplace_back();
    require_equal_lengths(recorded);
    return recorded;
  }

  std::string file_;
  RecordedSweep sweep_;
  const diagram::RecordRequest& request_;
  std::size_t columns_;  ///< of the recording, including the time
  std::size_t next_ = 0, at_once_ = 1;
  std::deque<Recorded> ahead_;
  Recorded current_;
  std::string left_over_;
};

}  // namespace

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

std::string place_of_row(const Recorded& recorded, std::size_t row) {
  return recorded.has_lines ? fmt::format("{}:{}", recorded.file, row + 2)
                            : fmt::format("{}: row {}", recorded.file, row + 1);
}

std::string difference_text(const Recorded& recorded, std::size_t row, std::size_t column, double time,
                            double computed) {
  const table::Column& found = recorded.table.columns[column];
  return fmt::format("{}: {} at {} s is {} and {} when it is replayed", place_of_row(recorded, row),
                     found.name, time, found.values[row], computed);
}

std::string extra_row_text(const Recorded& recorded, std::size_t row, double end) {
  return fmt::format("{}: there is a row at {} s, but the replay ends at {} s", place_of_row(recorded, row),
                     recorded.times()[row], end);
}

bool has_columns(const table::Table& table, std::size_t first_signal, const plan::Plan& plan,
                 const diagram::RecordRequest& request) {
  const std::vector<std::string> wanted = titles(plan, request);
  if (table.columns.size() + 1 != first_signal + wanted.size()) return false;
  if (title(table.columns.front()) != wanted.front()) return false;
  for (std::size_t i = 1; i < wanted.size(); ++i)
    if (title(table.columns[first_signal + i - 1]) != wanted[i]) return false;
  return true;
}

void require_columns(const Recorded& recorded, const plan::Plan& plan,
                     const diagram::RecordRequest& request) {
  if (has_columns(recorded.table, recorded.first_signal, plan, request)) return;
  std::vector<std::string> found;
  for (const table::Column& column : recorded.table.columns) found.push_back(title(column));
  throw yaml::Error(yaml::Fault{{recorded.file, recorded.has_lines ? yaml::Mark{1, 1} : yaml::Mark{}},
                                "",
                                fmt::format("its columns are {}; {} records {}", fmt::join(found, ", "),
                                            plan.diagram.file, fmt::join(titles(plan, request), ", ")),
                                {}});
}

std::string recorded_file(const std::string& folder, std::size_t recording) {
  const std::string csv = path_of(folder, recording, ".csv"), h5 = path_of(folder, recording, ".h5");
  if (is_there(csv)) return csv;
  if (is_there(h5)) return h5;
  throw yaml::Error(yaml::Fault{{csv, {}},
                                "",
                                fmt::format("is missing; verify needs it or {}, which 'run --out' writes of "
                                            "a diagram that records something, with csv or "
                                            "h5 among '--files'",
                                            std::filesystem::path(h5).filename().string()),
                                {}});
}

Recorded read_recorded(const std::string& file, std::size_t first_signal, table::ColumnWords& words) {
  if (has_lines(file)) return {file, table::read_csv(file, words), first_signal};
  table::RecordTable table = hdf5::read_hdf5(file);
  words = std::move(table.words);
  Recorded recorded{file, std::move(table), first_signal, false};
  require_equal_lengths(recorded);
  return recorded;
}

std::unique_ptr<RecordedRuns> open_recorded_runs(const std::string& file, std::size_t request,
                                                 const RecordedSweep& sweep) {
  if (has_lines(file)) return std::make_unique<RunsOfText>(file, request, sweep);
  return std::make_unique<RunsOfGroups>(file, request, sweep);
}

}  // namespace stepwire::replay
