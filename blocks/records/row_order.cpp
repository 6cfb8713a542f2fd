#include "blocks/records/row_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "blocks/records/record.hpp"

namespace stepwire {

namespace {

std::string counted(std::size_t count, const std::string& one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

/// Removes rows in which the time or one of the columns has no value.
void skip_missing(const RowsAsked& asked, RowOrder& order) {
  std::vector<const table::Column*> columns = asked.columns;
  if (asked.time) columns.push_back(asked.time);
  std::vector<std::string> names;
  for (const table::Column* column : columns)
    if (first_missing(column->values, order.rows)) names.push_back("'" + column->name + "'");
  const std::size_t left_out = std::erase_if(order.rows, [&](std::size_t row) {
    const bool missing =
        std::ranges::any_of(columns, [&](const auto* column) { return std::isnan(column->values[row]); });
    if (missing && !(asked.time && std::isnan(asked.time->values[row]))) order.left_out.push_back(row);
    return missing;
  });
  if (left_out > 0)
    order.notes.push_back(
        fmt::format("{} without {} left out", counted(left_out, "row"), fmt::join(names, ", ")));
}

/// Returns the row in `rows` with an earlier time than the previous one; the end if the times do not
/// decrease.
auto first_decrease(const std::vector<double>& time, const std::vector<std::size_t>& rows) {
  const auto pair = std::ranges::adjacent_find(
      rows, [&](std::size_t before, std::size_t row) { return time[row] < time[before]; });
  return pair == rows.end() ? pair : pair + 1;
}

void sort_rows(const RowsAsked& asked, RowOrder& order) {
  const std::vector<double>& time = asked.time->values;
  const auto row = first_decrease(time, order.rows);
  if (row == order.rows.end()) return;
  if (!asked.sort)
    throw RowsRefused(fmt::format(
        "{} is {}, after {} in the row before; times must increase, or say `sort: true`",
        place_in_file(asked.file, asked.table, asked.time->name, *row), time[*row], time[*(row - 1)]));
  std::ranges::stable_sort(order.rows, {}, [&](std::size_t one) { return time[one]; });
  order.notes.push_back(fmt::format("rows sorted by '{}'", asked.time->name));
}

void find_jumps(const RowsAsked& asked, RowOrder& order) {
  const std::vector<double>& time = asked.time->values;
  const std::vector<std::size_t>& rows = order.rows;
  std::size_t jumps = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (time[rows[i]] != time[rows[i - 1]]) continue;
    ++jumps;
    if (i + 1 < rows.size() && time[rows[i + 1]] == time[rows[i]])
      throw RowsRefused(fmt::format(
          "{} is {}, as in the two rows before; two rows of one time are a jump, more are none: give "
          "`sample_time` where the clock is too coarse for evenly spaced rows",
          place_in_file(asked.file, asked.table, asked.time->name, rows[i + 1]), time[rows[i]]));
  }
  if (jumps > 0) order.notes.push_back(counted(jumps, "jump") + " by two rows of one time");
}

}  // namespace

RowOrder ordered_rows(const RowsAsked& asked) {
  RowOrder order;
  order.rows.resize(asked.columns.front()->values.size());
  std::iota(order.rows.begin(), order.rows.end(), std::size_t{0});
  if (asked.skip_missing) skip_missing(asked, order);
  if (!asked.time) return order;
  if (const auto row = first_missing(asked.time->values, order.rows))
    throw RowsRefused(
        fmt::format("{} has no value; a time cannot be held: say `missing: skip` to leave the row out",
                    place_in_file(asked.file, asked.table, asked.time->name, *row)));
  sort_rows(asked, order);
  find_jumps(asked, order);
  return order;
}

}  // namespace stepwire
