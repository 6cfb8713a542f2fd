#include "engine/analyse/comparison/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/base/text/count.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::comparison {

namespace {

/// Name of a column without the group of its run: "run-2/" and "x" of "run-2/x".
struct GroupedName {
  std::string group, name;
};

GroupedName grouped(const std::string& column) {
  const std::size_t slash = column.find('/');
  if (slash == column.npos || !column.starts_with("run-")) return {"", column};
  const bool numbered = slash > 4 && std::all_of(column.begin() + 4, column.begin() + slash, [](char c) {
                          return std::isdigit(static_cast<unsigned char>(c)) != 0;
                        });
  return numbered ? GroupedName{column.substr(0, slash + 1), column.substr(slash + 1)}
                  : GroupedName{"", column};
}

bool is_time(const std::string& name) {
  return name == "time" || name == "Time" || name == "t";
}

/// Returns the first row of each run: the rows at which the time goes back.
std::vector<std::size_t> starts_of(const std::vector<double>& time) {
  std::vector<std::size_t> starts{0};
  for (std::size_t row = 1; row < time.size(); ++row)
    if (time[row] < time[row - 1]) starts.push_back(row);
  return starts;
}

std::string fault_of_time(const table::Column& time) {
  const auto unit = unit::parse_unit(time.unit.empty() ? "s" : time.unit);
  if (!unit || unit->dimension != unit::parse_unit("s")->dimension)
    return fmt::format("'{}' is in {}, which is no time", time.name, time.unit);
  for (std::size_t row = 0; row < time.values.size(); ++row)
    if (!std::isfinite(time.values[row]))
      return fmt::format("'{}' has no number in row {}", time.name, row + 1);
  return "";
}

std::vector<double> in_si(std::span<const double> values, const std::string& name) {
  std::vector<double> converted(values.begin(), values.end());
  const auto unit = unit::parse_unit(name);
  if (name.empty() || !unit) return converted;
  for (double& value : converted) value = unit->to_si(value);
  return converted;
}

}  // namespace

TraceIndex::TraceIndex(std::span<const table::Table* const> tables, std::vector<std::string>& faults) {
  for (const table::Table* table : tables) add_table(*table, faults);
}

void TraceIndex::add_table(const table::Table& table, std::vector<std::string>& faults) {
  std::map<std::string, const table::Column*> times;
  for (const table::Column& column : table.columns) {
    const auto [group, name] = grouped(column.name);
    if (!is_time(name) || times.contains(group)) continue;
    if (const std::string fault = fault_of_time(column); !fault.empty()) faults.push_back(fault);
    times[group] = &column;
  }
  for (const table::Column& column : table.columns) {
    const auto [group, name] = grouped(column.name);
    const auto time = times.find(group);
    if (time == times.end())
      return faults.push_back(
          fmt::format("'{}' has no times; a recording has a column 'time [s]'", column.name));
    if (time->second != &column) add(name, *time->second, column, faults);
  }
}

void TraceIndex::add(const std::string& name, const table::Column& time, const table::Column& values,
                     std::vector<std::string>& faults) {
  const bool constant = values.values.size() == 1;
  if (!constant && values.values.size() != time.values.size())
    return faults.push_back(fmt::format("'{}' has {} and '{}' {}; a signal has a value for each time",
                                        values.name, text::counted(values.values.size(), "row"), time.name,
                                        time.values.size()));
  const auto [at, is_new] = signals_.try_emplace(name, Signal{values.unit, {}});
  if (is_new) names_.push_back(name);
  if (at->second.unit != values.unit)
    return faults.push_back(
        fmt::format("'{}' is in '{}' in one run and in '{}' in another", name, at->second.unit, values.unit));
  const std::vector<std::size_t> starts = starts_of(time.values);
  for (std::size_t run = 0; run < starts.size(); ++run)
    at->second.pieces.push_back(
        {&time, &values, starts[run], run + 1 < starts.size() ? starts[run + 1] : time.values.size()});
}

Trace TraceIndex::trace(const std::string& name, std::size_t run) const {
  const Piece& piece = signals_.at(name).pieces.at(run);
  const std::size_t count = piece.end - piece.begin;
  Trace trace;
  trace.time = in_si(std::span(piece.time->values).subspan(piece.begin, count), piece.time->unit);
  if (piece.values->values.size() == 1)
    trace.values.assign(count, in_si(piece.values->values, piece.values->unit).front());
  else
    trace.values = in_si(std::span(piece.values->values).subspan(piece.begin, count), piece.values->unit);
  return trace;
}

}  // namespace stepwire::comparison
