#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/claim/claim_words.hpp"
#include "engine/analyse/claim/reduce.hpp"

namespace stepwire::claim {
namespace {

/// Why a claim has no value.
struct Unjudged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A comparison with a number that is undefined is neither true nor false.
void leave_undefined(const query::Formula& formula, const record::Recording& recording,
                     std::vector<double>& values) {
  for (const std::string& name : formula.columns) {
    const table::Column& column = *recording.table.find(name);  // evaluate() has found it
    for (std::size_t row = 0; row < values.size(); ++row)
      if (std::isnan(column.values[row])) values[row] = query::nothing;
  }
}

/// Why a value is none.
std::string undefined_text(const Rows& rows) {
  std::size_t all = 0, undefined = 0;
  for (std::size_t row = 0; row < rows.value.size(); ++row) {
    if (!rows.selected[row]) continue;
    ++all;
    if (std::isnan(rows.value[row])) ++undefined;
  }
  if (undefined == 0) return "the value is not a number";
  return fmt::format("the value is not a number: undefined in {} of {}", undefined, all);
}

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

/// Row at which `final` or `at` looks in one run.
std::size_t row_looked_at(const Claim& claim, const Rows& rows, std::size_t run) {
  const std::size_t begin = rows.starts[run], end = rows.run_end(run);
  if (begin >= end) throw Unjudged(fmt::format("run {} recorded no row", run + 1));
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

double value_of_run(const Claim& claim, const Rows& rows, std::size_t run) {
  return has_one_row(claim) ? rows.value[row_looked_at(claim, rows, run)]
                            : reduce(claim.reduction, rows.of_run(run));
}

bool selects_any(const Rows& rows, std::size_t run) {
  const auto at = [&](std::size_t row) { return rows.selected.begin() + static_cast<std::ptrdiff_t>(row); };
  return std::find(at(rows.starts[run]), at(rows.run_end(run)), true) != at(rows.run_end(run));
}

/// A run and its value.
struct WorstRun {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::optional<std::size_t> run{};
};

/// The value of the run that comes off worst. Runs that `where` leaves out as a whole (by a swept parameter)
/// are not judged.
WorstRun worst_run(const Claim& claim, const Rows& rows) {
  WorstRun worst;
  double margin = std::numeric_limits<double>::infinity();
  for (std::size_t run = 0; run < rows.starts.size(); ++run) {
    if (claim.where && !selects_any(rows, run)) continue;
    const double value = value_of_run(claim, rows, run);
    const double found = claim.comparison.margin(value);
    if (worst.run && found >= margin) continue;
    worst = {value, run};
    margin = found;
  }
  return worst;
}

WorstRun value_of(const Claim& claim, const Rows& rows) {
  if (rows.value.empty()) throw Unjudged("no row was recorded");
  if (std::find(rows.selected.begin(), rows.selected.end(), true) == rows.selected.end())
    throw Unjudged(fmt::format("'{}' selects no row", claim.where->text));
  if (claim.each_run) return worst_run(claim, rows);
  const double value = reduce(claim.reduction, rows);
  if (claim.reduction != Reduction::max && claim.reduction != Reduction::min) return {value, {}};
  const WorstRun worst = worst_run(claim, rows);
  return {value, value == worst.value ? worst.run : std::nullopt};
}

/// How large the recorded quantities of the reduced one's kind are.
double magnitude_of(const Claim& claim, const record::Recording& recording) {
  const auto dimension = reduced_dimension(claim);
  double largest = 0.0;
  if (!dimension) return largest;
  for (const query::Formula& formula : claim.values)
    for (const std::string& name : formula.columns) {
      const table::Column* column = recording.table.find(name);
      const auto unit = column ? unit::parse_unit(column->unit) : std::nullopt;
      if (!unit || unit->dimension != *dimension) continue;
      for (const double value : column->values)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
  return largest;
}

/// ", 16 of 20": of how many runs a condition holds that has one row of each.
std::string count_text(const Claim& claim, double value, const Rows& rows) {
  const auto count = std::ranges::count(rows.selected, true);
  const bool single = rows.starts.size() == rows.value.size() && rows.value.size() > 1;
  if (claim.reduction != Reduction::fraction || claim.each_run || !single || std::isnan(value)) return {};
  return fmt::format(", {} of {}", std::lround(value * static_cast<double>(count)), count);
}

std::string shown_text(const Claim& claim, const WorstRun& found, const Rows& rows,
                       const record::Recording& recording) {
  std::string text =
      value_text(claim, found.value, magnitude_of(claim, recording)) + count_text(claim, found.value, rows);
  const std::size_t runs = recording.starts.size();
  if (found.run && runs > 1) text += fmt::format(", the worst of {} runs", runs);
  return text;
}

}  // namespace

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
      values[run] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  return values;
}

Verdict judge(const Claim& claim, std::span<const record::Recording> recordings) {
  Verdict verdict{claim.kind, claim.that, claim.check,     std::numeric_limits<double>::quiet_NaN(),
                  "none",     false,      claim.disagrees, ""};
  try {
    if (claim.recording >= recordings.size()) throw Unjudged("nothing was recorded");
    const Rows rows = rows_of(claim, recordings[claim.recording]);
    const WorstRun found = value_of(claim, rows);
    verdict.value = found.value;
    if (rows.starts.size() > 1) verdict.run = found.run;
    verdict.shown = shown_text(claim, found, rows, recordings[claim.recording]);
    verdict.holds = claim.comparison.margin(verdict.value) >= 0.0;
    if (std::isnan(verdict.value)) verdict.note = undefined_text(rows);
  } catch (const Unjudged& reason) {
    verdict.note = reason.what();
  } catch (const std::invalid_argument& missing) {
    verdict.note = missing.what();
  }
  return verdict;
}

}  // namespace stepwire::claim
