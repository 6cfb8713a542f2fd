#include "engine/analyse/claim/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/analyse/claim/claim_rows.hpp"
#include "engine/analyse/claim/claim_words.hpp"
#include "engine/analyse/claim/judge_runs.hpp"

namespace stepwire::claim {
namespace {

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

}  // namespace

bool keeps_rows(const Claim& claim) {
  return !claim.of_run && !claim.each_run && keeps_rows(claim.reduction);
}

void Judge::add(std::span<const record::Recording> runs) {
  if (claim_.recording >= runs.size()) return;
  if (runs_ > 0 && !missing_.empty()) return;
  missing_.clear();
  try {
    if (claim_.of_run)
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
    differs_ = differs_ || (worst_run_ && value != worst_);
    if (worst_run_ && found >= margin_) continue;
    worst_ = value;
    worst_run_ = runs_ + run;
    margin_ = found;
  }
}

void Judge::require_value() const {
  if (!missing_.empty()) throw Unjudged(missing_);
  if (claim_.of_run) return;
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
  if (worst && runs_ > 1 && differs_) text += fmt::format(", the worst of {} runs", runs_);
  return text;
}

Verdict Judge::verdict() const {
  Verdict verdict{claim_.kind, claim_.that, claim_.check,     std::numeric_limits<double>::quiet_NaN(),
                  "none",      false,       claim_.disagrees, ""};
  try {
    require_value();
    if (claim_.of_run) {
      judge_runs(claim_, numbers_, verdict);
      return verdict;
    }
    verdict.value = value();
    const auto worst = claim_.each_run || verdict.value == worst_ ? worst_run_ : std::nullopt;
    if (runs_ > 1 && differs_) verdict.run = worst;
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

}  // namespace stepwire::claim
