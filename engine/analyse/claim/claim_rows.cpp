#include "engine/analyse/claim/claim_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stepwire::claim {
namespace {

/// Sets the result to nan where a column of a comparison is nan; the comparison is neither true nor false
/// there.
void leave_undefined(const query::Formula& formula, const record::Recording& recording,
                     std::vector<double>& values) {
  for (const std::string& name : formula.columns) {
    const table::Column& column = *recording.table.find(name);  // evaluate() has found it
    for (std::size_t row = 0; row < values.size(); ++row)
      if (std::isnan(column.values[row])) values[row] = query::nothing;
  }
}

/// Returns the row that `final` or `at` reads in one run.
std::size_t row_looked_at(const Claim& claim, const Rows& rows, std::size_t run) {
  const std::size_t begin = rows.starts[run], end = rows.run_end(run);
  if (claim.reduction == Reduction::final)
    for (std::size_t row = end; row-- > begin;)
      if (rows.selected[row]) return row;
  const double last = rows.time[end - 1], slack = end - begin > 1 ? last - rows.time[end - 2] : 0.0;
  if (claim.time < rows.time[begin] || claim.time > last + 0.5 * slack)
    throw Unjudged(fmt::format("there is no row at {} s; the record goes from {} s to {} s", claim.time,
                               rows.time[begin], last));
  std::size_t nearest = begin;
  for (std::size_t row = begin; row < end; ++row)
    if (std::abs(rows.time[row] - claim.time) < std::abs(rows.time[nearest] - claim.time)) nearest = row;
  if (!rows.selected[nearest])
    throw Unjudged(
        fmt::format("'{}' does not select the row at {} s", claim.where->text, rows.time[nearest]));
  return nearest;
}

bool has_one_row(const Claim& claim) {
  return claim.reduction == Reduction::final || claim.reduction == Reduction::at;
}

}  // namespace

Rows rows_of(const Claim& claim, const record::Recording& recording) {
  Rows rows;
  rows.value = query::evaluate(claim.values.at(0), recording);
  if (claim.values.size() > 1) rows.other = query::evaluate(claim.values[1], recording);
  if (const table::Column* time = recording.table.find("time"))
    rows.time = time->values;
  else
    throw Unjudged("no time was recorded");
  if (claim.reduction == Reduction::fraction || claim.reduction == Reduction::count)
    leave_undefined(claim.values[0], recording, rows.value);
  rows.selected.assign(rows.value.size(), true);
  rows.starts = recording.starts;
  rows.free_offset = claim.free_offset;
  rows.share = claim.share;
  if (!claim.where) return rows;
  const auto where = query::evaluate(*claim.where, recording);
  // A condition that is nan is not met.
  for (std::size_t i = 0; i < where.size(); ++i) rows.selected[i] = where[i] != 0.0 && !std::isnan(where[i]);
  return rows;
}

double value_of_run(const Claim& claim, const Rows& rows, std::size_t run) {
  return has_one_row(claim) ? rows.value[row_looked_at(claim, rows, run)]
                            : reduce(claim.reduction, rows.of_run(run));
}

bool selects_any(const Rows& rows, std::size_t run) {
  const auto at = [&](std::size_t row) { return rows.selected.begin() + static_cast<std::ptrdiff_t>(row); };
  return std::find(at(rows.starts[run]), at(rows.run_end(run)), true) != at(rows.run_end(run));
}

std::vector<std::optional<double>> values_of_runs(const Claim& claim,
                                                  std::span<const record::Recording> recordings) {
  if (claim.recording >= recordings.size()) return {};
  const Rows rows = rows_of(claim, recordings[claim.recording]);
  std::vector<std::optional<double>> values(rows.starts.size());
  for (std::size_t run = 0; run < values.size(); ++run) {
    if (!selects_any(rows, run)) continue;
    try {
      values[run] = value_of_run(claim, rows, run);
    } catch (const Unjudged&) {
      values[run] = query::nothing;
    }
  }
  return values;
}

}  // namespace stepwire::claim
