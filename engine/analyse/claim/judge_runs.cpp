#include "engine/analyse/claim/judge_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/claim/claim_words.hpp"
#include "engine/analyse/claim/run_formula.hpp"
#include "engine/analyse/statistics/proportion.hpp"
#include "engine/analyse/statistics/quartiles.hpp"

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
  return fmt::format("{} in {} runs ({} to {} at {:g} % confidence)", text(found.value), runs,
                     text(found.interval.low), text(found.interval.high), 100.0 * confidence);
}

}  // namespace

void add_numbers(const Claim& claim, std::span<const record::Recording> runs, std::vector<double>& numbers) {
  const auto values = values_of(*claim.of_run, runs);
  const record::Recording& recording = runs[claim.recording];
  const std::vector<double> where =
      claim.where ? query::evaluate(*claim.where, recording) : std::vector<double>{};
  for (std::size_t run = 0; run < values.size(); ++run)
    if (values[run] && (!claim.where || is_selected(where, recording, run))) numbers.push_back(*values[run]);
}

void judge_runs(const Claim& claim, const std::vector<double>& numbers, Verdict& verdict) {
  const auto undefined = std::ranges::count_if(numbers, [](double number) { return std::isnan(number); });
  if (numbers.empty()) {
    verdict.note = "no run counts";
    return;
  }
  if (undefined > 0) {
    verdict.note = fmt::format("the value is not a number in {} of {} runs", undefined, numbers.size());
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

}  // namespace stepwire::claim
