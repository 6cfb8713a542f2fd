#include "engine/analyse/claim/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "engine/analyse/claim/likeness.hpp"
#include "engine/analyse/claim/run_formula.hpp"
#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/analyse/statistics/proportion.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::claim {
namespace {

constexpr double shown_confidence = 0.95;  // default of claims without a confidence level

/// Estimate over several runs with its confidence interval.
struct Found {
  double value = query::nothing;
  statistics::ConfidenceInterval interval{query::nothing, query::nothing};
  bool low_is_open = false, high_is_open = false;  ///< True: more runs are needed to bound that end.
};

/// True if `where` selects a row of the run.
bool is_selected(const std::vector<double>& where, const record::Recording& recording, std::size_t run) {
  const std::size_t end =
      run + 1 < recording.starts.size() ? recording.starts[run + 1] : recording.table.rows();
  for (std::size_t row = recording.starts[run]; row < end; ++row)
    if (where[row] != 0.0 && !std::isnan(where[row])) return true;
  return false;
}

Found fraction_of(const std::vector<double>& numbers, double confidence) {
  const auto count =
      static_cast<std::size_t>(std::ranges::count_if(numbers, [](double number) { return number != 0.0; }));
  return {static_cast<double>(count) / static_cast<double>(numbers.size()),
          statistics::proportion_interval(count, numbers.size(), confidence)};
}

Found quantile_of(std::vector<double> numbers, double share, double confidence) {
  std::ranges::sort(numbers);
  const statistics::RankInterval ranks = statistics::quantile_ranks(numbers.size(), share, confidence);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {statistics::hazen_quantile(numbers, share),
          {ranks.low ? numbers[*ranks.low] : -infinity, ranks.high ? numbers[*ranks.high] : infinity},
          !ranks.low,
          !ranks.high};
}

/// Returns the reason why the runs are too few for a verdict: the deciding end of the interval is open. Empty
/// if they suffice.
std::string undecided(const Claim& claim, const Found& found, double confidence, std::size_t runs) {
  const Comparison& comparison = claim.comparison;
  const bool low = found.low_is_open && comparison.margin(found.interval.low) < 0.0;
  const bool high = found.high_is_open && comparison.margin(found.interval.high) < 0.0;
  if (!low && !high) return "";
  const std::string side = low && high ? "" : low ? " from below" : " from above";
  if (claim.share <= 0.0 || claim.share >= 1.0)
    return fmt::format(
        "undecided: no number of runs bounds the {:g} % quantile{}; take a share between 0 and 1",
        100.0 * claim.share, side);
  return fmt::format("undecided: {} runs do not bound the {:g} % quantile{} at {:g} % confidence; {} runs do",
                     runs, 100.0 * claim.share, side, 100.0 * confidence,
                     statistics::values_for_both_ranks(claim.share, confidence));
}

std::string shown_text(const Claim& claim, const Found& found, double confidence, std::size_t runs) {
  const auto text = [&](double value) { return value_text(claim, value, std::abs(found.value)); };
  return fmt::format("{} in {} ({} to {} at {:g} % confidence)", text(found.value),
                     text::counted(runs, "run"), text(found.interval.low), text(found.interval.high),
                     100.0 * confidence);
}

/// Adds the numbers of the selected runs, for a claim about a fraction or a quantile of runs. Throws
/// std::invalid_argument for a missing column.
void add_numbers(const Claim& claim, std::span<const record::Recording> runs, std::vector<double>& numbers) {
  const auto values = values_of(*claim.of_run, runs);
  const record::Recording& recording = runs[claim.recording];
  const std::vector<double> where =
      claim.where ? query::evaluate(*claim.where, recording) : std::vector<double>{};
  for (std::size_t run = 0; run < values.size(); ++run)
    if (values[run] && (!claim.where || is_selected(where, recording, run))) numbers.push_back(*values[run]);
}

/// Judges such a claim on the numbers of all selected runs.
void judge_runs(const Claim& claim, const std::vector<double>& numbers, Verdict& verdict) {
  const auto undefined = std::ranges::count_if(numbers, [](double number) { return std::isnan(number); });
  if (numbers.empty()) {
    verdict.note = "no run counts";
    return;
  }
  if (undefined > 0) {
    verdict.note =
        fmt::format("the value is not a number in {} of {}", undefined, text::counted(numbers.size(), "run"));
    return;
  }
  const double confidence = claim.confidence.value_or(shown_confidence);
  const Found found = claim.reduction == Reduction::fraction_of_runs
                          ? fraction_of(numbers, confidence)
                          : quantile_of(numbers, claim.share, confidence);
  verdict.value = found.value;
  verdict.interval = found.interval;
  verdict.confidence = confidence;
  verdict.shown = shown_text(claim, found, confidence, numbers.size());
  verdict.note = undecided(claim, found, confidence, numbers.size());
  if (!verdict.note.empty()) return;
  const Comparison& comparison = claim.comparison;
  verdict.holds = claim.confidence ? std::min(comparison.margin(found.interval.low),
                                              comparison.margin(found.interval.high)) >= 0.0
                                   : comparison.margin(found.value) >= 0.0;
}

/// Error: a claim has no value. The text holds the reason.
struct Unjudged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Returns the last selected row of a run.
std::size_t last_row(const Rows& rows, std::size_t run) {
  std::size_t row = rows.run_end(run) - 1;
  while (!rows.selected[row]) --row;
  return row;
}

void require_selected(const Claim& claim, const Rows& rows, std::size_t row) {
  if (!rows.selected[row])
    throw Unjudged(fmt::format("'{}' does not select the row at {} s", claim.where->text, rows.time[row]));
}

/// True for the step response of an analysis, a curve with rows of its own choice.
bool reads_response(const Claim& claim) {
  return std::ranges::any_of(claim.values.at(0).columns,
                             [](const std::string& name) { return name.ends_with(".step.response"); });
}

/// Returns the value of a run at the time of a claim: that of the last row there. Between two rows only a
/// response has one.
double value_at(const Claim& claim, const Rows& rows, std::size_t run) {
  const std::size_t begin = rows.starts[run], end = rows.run_end(run);
  const double rounding = 1e-9 * std::max(std::abs(claim.time), std::abs(rows.time[end - 1]));
  std::size_t next = begin;
  while (next < end && rows.time[next] <= claim.time + rounding) ++next;
  if (next > begin && std::abs(rows.time[next - 1] - claim.time) <= rounding) {
    require_selected(claim, rows, next - 1);
    return rows.value[next - 1];
  }
  if (next == begin || next == end)
    throw Unjudged(fmt::format("there is no row at {} s; the record goes from {} s to {} s", claim.time,
                               rows.time[begin], rows.time[end - 1]));
  if (!reads_response(claim))
    throw Unjudged(fmt::format("there is no row at {} s; the nearest ones are at {} s and {} s", claim.time,
                               rows.time[next - 1], rows.time[next]));
  require_selected(claim, rows, next - 1);
  const double part = (claim.time - rows.time[next - 1]) / (rows.time[next] - rows.time[next - 1]);
  return rows.value[next - 1] + part * (rows.value[next] - rows.value[next - 1]);
}

/// Evaluates a claim's formulas on a recording. Throws Unjudged, and std::invalid_argument for a missing
/// column.
Rows rows_of(const Claim& claim, const record::Recording& recording) {
  Rows rows;
  rows.value = query::evaluate(claim.values.at(0), recording);
  if (claim.values.size() > 1) rows.other = query::evaluate(claim.values[1], recording);
  if (const table::Column* time = recording.table.find("time"))
    rows.time = time->values;
  else
    throw Unjudged("no time was recorded");
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

/// Returns the number of one run with at least one selected row. Throws Unjudged if it has none.
double value_of_run(const Claim& claim, const Rows& rows, std::size_t run) {
  if (claim.reduction == Reduction::final) return rows.value[last_row(rows, run)];
  if (claim.reduction == Reduction::at) return value_at(claim, rows, run);
  if (rows.starts.size() == 1) return reduce(claim.reduction, rows);
  return reduce(claim.reduction, rows.of_run(run));
}

/// True if `where` selects at least one row of a run.
bool selects_any(const Rows& rows, std::size_t run) {
  const auto at = [&](std::size_t row) { return rows.selected.begin() + static_cast<std::ptrdiff_t>(row); };
  return std::find(at(rows.starts[run]), at(rows.run_end(run)), true) != at(rows.run_end(run));
}

/// True if the claim judges a number of each run.
bool looks_at_runs(const Claim& claim) {
  return claim.each_run || claim.reduction == Reduction::max || claim.reduction == Reduction::min;
}

/// Returns the largest recorded number of the dimension of the reduced value.
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

/// Returns the excess of each run over the tolerance of a baseline; nan where it cannot be compared.
std::vector<std::optional<double>> excesses_of_runs(const Likeness& likeness,
                                                    std::span<const record::Recording> recordings) {
  std::vector<std::optional<double>> values;
  for (std::size_t run = 0; run < recordings.front().starts.size(); ++run) {
    LikenessFound found;
    std::vector<record::Recording> one = run_of(recordings, run);
    add_likeness(likeness, one, run, found);
    values.push_back(found.fault.empty() ? found.excess : query::nothing);
  }
  return values;
}

}  // namespace

bool keeps_rows(const Claim& claim) {
  return !claim.of_run && !claim.each_run && keeps_rows(claim.reduction);
}

void Judge::add(std::span<const record::Recording> runs) {
  if (claim_.recording >= runs.size()) return;
  if (runs_ > 0 && !missing_.empty()) return;
  missing_.clear();
  try {
    if (claim_.like)
      add_likeness(*claim_.like, runs, runs_, like_);
    else if (claim_.of_run)
      add_numbers(claim_, runs, numbers_);
    else
      add_rows(runs[claim_.recording]);
    runs_ += runs[claim_.recording].starts.size();
  } catch (const Unjudged& reason) {
    missing_ = reason.what();
  } catch (const std::invalid_argument& missing) {
    missing_ = missing.what();
  }
}

void Judge::add_rows(const record::Recording& runs) {
  const Rows rows = rows_of(claim_, runs);
  rows_ += rows.value.size();
  for (std::size_t row = 0; row < rows.value.size(); ++row) {
    if (!rows.selected[row]) continue;
    ++selected_;
    if (std::isnan(rows.value[row])) ++undefined_;
  }
  magnitude_ = std::max(magnitude_, magnitude_of(claim_, runs));
  if (!claim_.each_run) all_.add(rows);
  try {
    if (looks_at_runs(claim_) && trouble_.empty()) add_runs(rows);
  } catch (const Unjudged& reason) {
    trouble_ = reason.what();
  }
}

/// Finds the run with the smallest margin. Runs of which `where` selects no row are not judged.
void Judge::add_runs(const Rows& rows) {
  for (std::size_t run = 0; run < rows.starts.size(); ++run) {
    if (claim_.where && !selects_any(rows, run)) continue;
    if (rows.starts[run] >= rows.run_end(run))
      throw Unjudged(fmt::format("run {} recorded no row", runs_ + run + 1));
    const double value = value_of_run(claim_, rows, run);
    const double found = claim_.comparison.margin(value);
    ++judged_;
    differs_ = differs_ || (worst_run_ && value != worst_);
    if (worst_run_ && found >= margin_) continue;
    worst_ = value;
    worst_run_ = runs_ + run;
    margin_ = found;
  }
}

void Judge::require_value() const {
  if (!missing_.empty()) throw Unjudged(missing_);
  if (claim_.of_run || claim_.like) return;
  if (rows_ == 0) throw Unjudged("no row was recorded");
  if (selected_ == 0) throw Unjudged(fmt::format("'{}' selects no row", claim_.where->text));
  if (!trouble_.empty()) throw Unjudged(trouble_);
}

double Judge::value() const {
  return claim_.each_run ? worst_ : all_.value();
}

std::string Judge::note_of_undefined() const {
  if (undefined_ == 0) return "the value is not a number";
  return fmt::format("the value is not a number: undefined in {} of {}", undefined_, selected_);
}

/// Returns the value as text. A condition with one row per run gets a suffix such as ", 16 of 20".
std::string Judge::shown(double value, std::optional<std::size_t> worst) const {
  std::string text = value_text(claim_, value, magnitude_);
  const bool single = runs_ == rows_ && rows_ > 1;
  if (claim_.reduction == Reduction::fraction && !claim_.each_run && single && !std::isnan(value))
    text += fmt::format(", {} of {}", std::lround(value * static_cast<double>(selected_)), selected_);
  if (worst && judged_ > 1 && differs_) text += fmt::format(", the worst of {} runs", judged_);
  return text;
}

void Judge::judge_likeness(Verdict& verdict) const {
  if (!like_.fault.empty()) throw Unjudged(like_.fault);
  if (!like_.run) throw Unjudged("no row was recorded");
  verdict.value = like_.excess;
  verdict.shown = like_.text + (runs_ > 1 ? fmt::format(", the worst of {} runs", runs_) : "");
  verdict.holds = like_.excess <= 1.0;
  if (runs_ > 1) verdict.run = like_.run;
}

Verdict Judge::verdict() const {
  Verdict verdict{claim_.kind, claim_.that, claim_.check,     std::numeric_limits<double>::quiet_NaN(),
                  "none",      false,       claim_.disagrees, ""};
  try {
    require_value();
    if (claim_.like || claim_.of_run) {
      claim_.like ? judge_likeness(verdict) : judge_runs(claim_, numbers_, verdict);
      return verdict;
    }
    verdict.value = value();
    const auto worst = claim_.each_run || verdict.value == worst_ ? worst_run_ : std::nullopt;
    if (judged_ > 1 && differs_) verdict.run = worst;
    verdict.shown = shown(verdict.value, worst);
    verdict.holds = claim_.comparison.margin(verdict.value) >= 0.0;
    if (std::isnan(verdict.value)) verdict.note = note_of_undefined();
  } catch (const Unjudged& reason) {
    verdict.note = reason.what();
  }
  return verdict;
}

Verdict judge(const Claim& claim, std::span<const record::Recording> recordings) {
  Judge judge(claim);
  judge.add(recordings);
  return judge.verdict();
}

std::vector<std::optional<double>> values_of_runs(const Claim& claim,
                                                  std::span<const record::Recording> recordings) {
  if (claim.recording >= recordings.size()) return {};
  if (claim.like) return excesses_of_runs(*claim.like, recordings);
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
