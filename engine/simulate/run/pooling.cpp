#include "engine/simulate/run/pooling.hpp"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include "engine/base/parallel/parallel.hpp"
#include "engine/simulate/record/recorder.hpp"

namespace stepwire::run {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Resizes a column whose memory is in huge pages, if the kernel has them. Otherwise a page fault for every
/// few hundred numbers is most of the cost of recording.
void lengthen(std::vector<double>& values, std::size_t size) {
  constexpr std::uintptr_t huge = 2u << 20;
  values.reserve(size);
  const auto address = reinterpret_cast<std::uintptr_t>(values.data());
  const std::uintptr_t first = (address + huge - 1) / huge * huge;
  const std::uintptr_t end = (address + size * sizeof(double)) / huge * huge;
  if (first < end) ::madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
  values.resize(size);
}

/// Returns the swept parameter of a diagram; nullptr if the value of a block is swept.
const diagram::DiagramParameter* parameter_of(const diagram::Diagram& diagram, const std::string& name) {
  const auto found = std::ranges::find(diagram.parameters, name, &diagram::DiagramParameter::name);
  return found == diagram.parameters.end() ? nullptr : &*found;
}

/// True if the value depends on parameters.
bool is_formula(const std::string& text) {
  return text.starts_with('=') || text.starts_with('$');
}

/// Returns the index of each text among the categories.
std::vector<double> indices_of(const std::vector<std::string>& texts,
                               const std::vector<std::string>& categories) {
  std::vector<double> indices;
  for (const std::string& text : texts)
    indices.push_back(static_cast<double>(std::ranges::find(categories, text) - categories.begin()));
  return indices;
}

/// Returns the numbers of the texts; an empty list if one of them is a formula.
std::vector<double> numbers_of(const std::vector<std::string>& texts) {
  if (std::ranges::any_of(texts, is_formula)) return {};
  std::vector<double> numbers;
  for (const std::string& text : texts) numbers.push_back(unit::parse_quantity(text)->value);
  return numbers;
}

}  // namespace

std::string settings_text(const std::vector<diagram::Setting>& settings) {
  std::string text;
  for (const diagram::Setting& setting : settings)
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", setting.name, setting.value);
  return text;
}

std::size_t telling_settings(const std::vector<std::vector<diagram::Setting>>& points) {
  std::size_t all = points.empty() ? 0 : points.front().size();
  for (const std::vector<diagram::Setting>& point : points) all = std::min(all, point.size());
  for (std::size_t count = 1; count < all; ++count) {
    std::set<std::string> seen;
    const bool differ = std::ranges::all_of(points, [&](const std::vector<diagram::Setting>& point) {
      return seen.insert(settings_text({point.begin(), point.begin() + static_cast<std::ptrdiff_t>(count)}))
          .second;
    });
    if (differ) return count;
  }
  return all;
}

bool has_words(const diagram::Sweep::Axis& axis) {
  if (axis.label) return true;
  const std::vector<std::string>& texts = axis.values.texts();
  return std::ranges::none_of(texts, is_formula) &&
         std::ranges::any_of(texts, [](const std::string& text) { return !unit::parse_quantity(text); });
}

std::vector<std::string> words_of(const diagram::Sweep::Axis& axis) {
  std::vector<std::string> categories;
  for (const std::string& word : axis.values.texts())
    if (std::ranges::find(categories, word) == categories.end()) categories.push_back(word);
  return categories;
}

SweptColumns::SweptColumns(const Job& job) : job_(job) {
  if (job.points.empty()) return;
  const diagram::Diagram& diagram = job.plan.diagram;
  for (const diagram::Sweep::Axis& axis : diagram.sweep->axes) {
    const diagram::DiagramParameter* parameter = parameter_of(diagram, axis.parameter);
    // A swept value of a block has the dimension of the axis, since the file may leave it to its default.
    const auto dimension = parameter && parameter->dimension ? parameter->dimension : axis.values.dimension();
    const bool is_words = has_words(axis);
    columns_.push_back({axis.parameter, dimension && !is_words ? unit::si_name(*dimension) : "", {}});
    if (is_words) {
      categories_.push_back({axis.parameter, words_of(axis)});
      numbers_.push_back(indices_of(axis.values.texts(), categories_.back().texts));
    } else {
      numbers_.push_back(numbers_of(axis.values.texts()));
    }
  }
}

/// Returns the value of a formula at a point.
double SweptColumns::evaluated(std::size_t axis, std::size_t point) const {
  const plan::Plan& plan = job_.plan_of(point);
  const std::string& name = columns_[axis].name;
  const diagram::DiagramParameter* parameter = parameter_of(plan.diagram, name);
  if (!parameter) return unknown;
  Executor run(plan);
  job_.family->begin(job_.points[point].member, job_.settings_of(point), run);
  const auto index = static_cast<std::size_t>(parameter - plan.diagram.parameters.data());
  const double* number = std::get_if<double>(&run.parameter(index).content);
  return number ? *number : unknown;
}

std::vector<double> SweptColumns::numbers(std::size_t point) const {
  std::vector<double> numbers;
  if (columns_.empty()) return numbers;
  const diagram::Sweep& sweep = *job_.plan.diagram.sweep;
  const auto index = sweep.indices(point);
  for (std::size_t axis = 0; axis < columns_.size(); ++axis) {
    const diagram::SweptValues& values = sweep.axes[axis].values;
    numbers.push_back(values.are_numbers()     ? values.number(index[axis])
                      : numbers_[axis].empty() ? evaluated(axis, point)
                                               : numbers_[axis][values.which(index[axis])]);
  }
  return numbers;
}

std::vector<table::Column> SweptColumns::of(std::size_t point) const {
  std::vector<table::Column> columns = columns_;
  const std::vector<double> values = numbers(point);
  for (std::size_t axis = 0; axis < columns.size(); ++axis) columns[axis].values = {values[axis]};
  return columns;
}

void SweptColumns::add(record::Recording& recording, std::size_t point) const {
  std::vector<table::Column> columns = of(point);
  for (table::Column& column : columns) column.values.assign(recording.table.rows(), column.values.front());
  recording.categories.insert(recording.categories.end(), categories_.begin(), categories_.end());
  recording.table.columns.insert(recording.table.columns.begin() + 1, columns.begin(), columns.end());
}

void append_runs(record::Recording& all, record::Recording&& more) {
  if (all.table.columns.empty()) {
    all = std::move(more);
    return;
  }
  const std::size_t rows = all.table.rows();
  for (const std::size_t start : more.starts) all.starts.push_back(rows + start);
  for (std::size_t i = 0; i < all.table.columns.size(); ++i) {
    auto& values = all.table.columns[i].values;
    values.insert(values.end(), more.table.columns[i].values.begin(), more.table.columns[i].values.end());
  }
}

PooledRecording::PooledRecording(const Job& job, const SweptColumns& swept, unsigned threads)
    : job_(job), swept_(swept) {
  for (const diagram::RecordRequest& request : job.plan.diagram.records) {
    Rows rows;
    rows.count.resize(job.points.size());
    std::size_t all = 0;
    for (std::size_t point = 0; point < job.points.size(); ++point) {
      const std::size_t index = all_.size();
      rows.first.push_back(all);
      all += record::max_rows(job.plan_of(point), job.plan_of(point).diagram.records[index]);
    }
    auto& columns = rows.recording.table.columns;
    columns = record::empty_columns(job.plan, request);
    columns.insert(columns.begin() + 1, swept.columns().begin(), swept.columns().end());
    rows.recording.categories = swept.categories();
    parallel::in_parallel(columns.size(), threads, [&](std::size_t c) { lengthen(columns[c].values, all); });
    all_.push_back(std::move(rows));
  }
}

std::vector<record::Recorder> PooledRecording::recorders(std::size_t point) {
  std::vector<record::Recorder> recorders;
  const plan::Plan& plan = job_.plan_of(point);
  for (std::size_t r = 0; r < all_.size(); ++r) {
    std::vector<double*> columns;
    for (table::Column& column : all_[r].recording.table.columns)
      columns.push_back(column.values.data() + all_[r].first[point]);
    columns.erase(columns.begin() + 1,
                  columns.begin() + 1 + static_cast<std::ptrdiff_t>(swept_.columns().size()));
    recorders.emplace_back(plan, plan.diagram.records[r], std::move(columns));
  }
  return recorders;
}

void PooledRecording::put(std::size_t point, const std::vector<record::Recording>& recorded,
                          const std::vector<std::size_t>& rows) {
  for (std::size_t r = 0; r < rows.size(); ++r) all_[r].count[point] = rows[r];
  for (std::size_t r = 0; r < recorded.size(); ++r) {
    const auto& from = recorded[r].table.columns;
    auto& to = all_[r].recording.table.columns;
    all_[r].count[point] = recorded[r].table.rows();
    const auto first = static_cast<std::ptrdiff_t>(all_[r].first[point]);
    for (std::size_t c = 0; c < from.size(); ++c)
      std::ranges::copy(from[c].values, to[c == 0 ? 0 : c + swept_.columns().size()].values.begin() + first);
  }
  fill_swept(point);
}

void PooledRecording::fill_swept(std::size_t point) {
  const std::vector<double> numbers = swept_.numbers(point);
  for (Rows& rows : all_)
    for (std::size_t axis = 0; axis < numbers.size(); ++axis)
      std::fill_n(rows.recording.table.columns[1 + axis].values.begin() +
                      static_cast<std::ptrdiff_t>(rows.first[point]),
                  rows.count[point], numbers[axis]);
}

void PooledRecording::close_gaps(Rows& rows) const {
  std::size_t end = 0;
  rows.recording.starts.clear();
  for (std::size_t point = 0; point < rows.first.size(); ++point) {
    rows.recording.starts.push_back(end);
    if (end != rows.first[point])
      for (table::Column& column : rows.recording.table.columns)
        std::copy_n(column.values.begin() + static_cast<std::ptrdiff_t>(rows.first[point]), rows.count[point],
                    column.values.begin() + static_cast<std::ptrdiff_t>(end));
    end += rows.count[point];
  }
  for (table::Column& column : rows.recording.table.columns) column.values.resize(end);
}

std::vector<record::Recording> PooledRecording::take() {
  std::vector<record::Recording> recordings;
  for (Rows& rows : all_) {
    close_gaps(rows);
    recordings.push_back(std::move(rows.recording));
  }
  return recordings;
}

}  // namespace stepwire::run
