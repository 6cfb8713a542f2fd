#include "engine/analyse/tuning/evaluation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stepwire::tuning {

namespace {

void judge_objective(const TuneRequest& request, std::span<const record::Recording> recordings,
                     Evaluation& of) {
  const std::vector<std::optional<double>> all = values_of(request.minimise, recordings);
  double sum = 0.0, count = 0.0, worst = -std::numeric_limits<double>::infinity();
  for (std::size_t run = 0; run < all.size(); ++run) {
    if (!all[run]) continue;
    sum += *all[run];
    ++count;
    if (std::isnan(*all[run]) || *all[run] <= worst) continue;
    worst = *all[run];
    of.worst = run;
  }
  if (count == 0.0)
    of.fault =
        fmt::format("'{}' has no value, since 'where' selects no row of any run", request.minimise.text);
  else if (!std::isfinite(sum))
    of.fault = fmt::format("'{}' has no finite value", request.minimise.text);
  else
    of.objective = request.over == TuneOver::worst ? worst : sum / count;
}

/// Sets the objective to the sum of the squared errors of the targets.
void judge_targets(const TuneRequest& request, std::span<const record::Recording> recordings,
                   Evaluation& of) {
  double sum = 0.0;
  for (const claim::Claim& target : request.targets) {
    const double value = claim::judge(target, recordings).value;
    of.offs.push_back((value - target.comparison.low) / target.comparison.within);
    sum += of.offs.back() * of.offs.back();
    if (!std::isfinite(of.offs.back()) && of.fault.empty())
      of.fault = fmt::format("'{}' has no finite value", target.that);
  }
  if (of.fault.empty()) of.objective = sum;
}

}  // namespace

bool Evaluation::is_feasible() const {
  return !is_bad() && std::ranges::all_of(margins, [](double margin) { return margin >= 0.0; });
}

Evaluation evaluate(const TuneRuns& runs, const TuneRequest& request, Values values, unsigned threads) {
  Evaluation of{.values = std::move(values)};
  const std::vector<record::Recording> recordings = runs.run(of.values, threads, of.fault);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!of.is_bad()) (request.targets.empty() ? judge_objective : judge_targets)(request, recordings, of);
  for (const claim::Claim& claim : request.constraints) {
    of.claims.push_back(recordings.empty() ? none : claim::judge(claim, recordings).value);
    of.margins.push_back(claim.comparison.margin(of.claims.back()));
  }
  return of;
}

}  // namespace stepwire::tuning
