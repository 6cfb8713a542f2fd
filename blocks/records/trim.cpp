#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "blocks/records/steps.hpp"

namespace stepwire {

namespace {

/// Returns the record's rows of a column of the file, in the file's unit.
std::vector<double> rows_of(const Record& record, const StepOptions& given) {
  const std::string name = given.text("trim");
  const table::Column* column = record.table->find(name);
  if (!column) given.refuse("trim", no_column(record.file, *record.table, name));
  if (const auto problem = record.table->problems.find(name); problem != record.table->problems.end())
    given.refuse("trim", problem->second);
  if (column->values.size() <= *std::ranges::max_element(record.file_rows))
    given.refuse("trim", fmt::format("{}: {} has {} rows, fewer than the record", record.file, name,
                                     column->values.size()));
  const std::vector<double> values = values_of_rows(*column, record.file_rows, record.hold_missing);
  const auto missing = std::ranges::find_if(values, [](double value) { return std::isnan(value); });
  if (missing != values.end())
    given.refuse("trim", missing_value(record, name,
                                       record.file_rows[static_cast<std::size_t>(missing - values.begin())]));
  return values;
}

struct Span {
  double begin, end;  // [s]
};

/// Returns when the column first differs from its first value, and last from its last one.
Span movement(const std::vector<double>& y, const std::vector<double>& time, double threshold) {
  const auto moved_from = [&](double rest) {
    return [rest, threshold](double value) { return std::abs(value - rest) > threshold; };
  };
  const auto begins = std::find_if(y.begin(), y.end(), moved_from(y.front()));
  const auto ends = std::find_if(y.rbegin(), y.rend(), moved_from(y.back()));
  return {time[static_cast<std::size_t>(begins - y.begin())],
          time[static_cast<std::size_t>(y.rend() - ends) - 1]};
}

/// Keeps the elements in [first, end).
void keep(std::vector<double>& values, std::ptrdiff_t first, std::ptrdiff_t end) {
  values = std::vector<double>(values.begin() + first, values.begin() + end);
}

}  // namespace

void trim(Record& record, const StepOptions& given) {
  const std::vector<double> y = rows_of(record, given);
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  const double share = given.has("threshold") ? given.positive("threshold", unit::Dimension{}) : 0.02;
  if (!(share < 1.0))
    given.refuse("threshold", "it is a share of the column's range and must be below 100 %");
  if (!(*high > *low))
    given.refuse("trim", fmt::format("in {} {} does not move: it is {} in all rows", record.file,
                                     given.text("trim"), *low));
  const double margin = given.has("margin") ? given.number("margin", time_dimension) : 0.0;
  const Span moving = movement(y, record.file_times, share * (*high - *low));
  const double slack = 1e-6 * record.interval();  // instants and rows are both rounded
  const auto& t = record.time;
  const auto first = std::lower_bound(t.begin(), t.end(), moving.begin - margin - slack) - t.begin();
  const auto end = std::upper_bound(t.begin(), t.end(), moving.end + margin + slack) - t.begin();
  if (end - first < 2)
    given.refuse(fmt::format("in {} {} moves from {} s to {} s; with a margin of {} s no two rows are left",
                             record.file, given.text("trim"), moving.begin, moving.end, margin));
  for (RecordColumn& column : record.columns) keep(column.values, first, end);
  keep(record.time, first, end);
}

}  // namespace stepwire
