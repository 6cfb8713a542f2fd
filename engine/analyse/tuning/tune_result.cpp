// Fields of the result of an optimisation.
#include "engine/analyse/tuning/tune.hpp"
#include "engine/base/result/record.hpp"

namespace stepwire::tuning {

using result::Record;

namespace {

/// Adds the fields of a verdict that begin those of a target and of a claim.
template <class Judged>
void add_verdict(Record<Judged>& is) {
  is.field("that", result::path(&Judged::verdict, &claim::Verdict::that), "statement");
  is.field("check", result::path(&Judged::verdict, &claim::Verdict::check), "condition");
  is.field("value", result::path(&Judged::verdict, &claim::Verdict::value), "value at the optimum", "SI");
}

}  // namespace

static void declare(Record<TunedNumber>& is) {
  is.named("TunedParameter", "A number that an optimisation found, in SI.");
  is.field("name", &TunedNumber::name, "name of the parameter");
  is.field("value", &TunedNumber::value, "value", "SI");
  is.field("unit", &TunedNumber::dimension, "SI unit; null if unknown");
  is.field("start", &TunedNumber::start, "value at the start", "SI");
  is.field(
      "bounds",
      [](const TunedNumber& of) {
        return std::array{of.lower, of.upper};
      },
      "bounds", "SI");
  is.field("interval", &TunedNumber::interval, "95 % interval; null in a free direction and without targets",
           "SI");
  is.field("at_bound", &TunedNumber::at_bound, "true at a bound");
}

/// A target with its row of the Jacobian.
struct TargetRow {
  claim::Verdict verdict;
  double off, start;
  std::vector<double> derivatives;
};

static void declare(Record<TargetRow>& is) {
  is.named("TunedTarget", "A target at the optimum.");
  add_verdict(is);
  is.field("off", &TargetRow::off, "error in units of its deviation");
  is.field("start", &TargetRow::start, "the same at the start");
  is.field("derivatives", &TargetRow::derivatives,
           "derivatives by the parameters, in deviations per range from bound to bound");
}

static void declare(Record<TunedClaim>& is) {
  is.named("TunedClaim", "A claim at the optimum.");
  add_verdict(is);
  is.field("shown", result::path(&TunedClaim::verdict, &claim::Verdict::shown), "value with its unit");
  is.field("start", &TunedClaim::start, "value at the start", "SI");
  is.field("margin", &TunedClaim::margin, "margin at the optimum; negative if the claim fails", "SI");
  is.field("holds", result::path(&TunedClaim::verdict, &claim::Verdict::holds), "true if it holds");
  is.field("active", &TunedClaim::active, "true if the claim limits the objective");
}

static void declare(Record<TunedStart>& is) {
  is.named("TunedStart", "Result of the search from one start.");
  is.field("objective", &TunedStart::objective, "objective; null if no point satisfies all claims", "SI");
  is.field("converged", &TunedStart::converged, "true if the search converged");
  is.field("evaluations", &TunedStart::evaluations, "number of evaluations");
}

namespace {

std::vector<TargetRow> target_rows(const TuneResult& of) {
  std::vector<TargetRow> rows;
  const auto& jacobian = of.resolution.jacobian;
  for (const TunedTarget& target : of.targets) {
    const std::size_t i = rows.size();
    rows.push_back({target.verdict, target.off, target.start,
                    i < jacobian.size() ? jacobian[i] : std::vector<double>{}});
  }
  return rows;
}

}  // namespace

void declare(Record<TuneResult>& is) {
  is.named("TuneResult", "The result of an optimisation: tune.json.");
  is.field("file", &TuneResult::file, "diagram file");
  is.field("minimise", &TuneResult::minimise, "expression of the objective");
  is.field("parameters", &TuneResult::numbers, "optimised numbers");
  is.field("objective", &TuneResult::objective, "objective at the optimum", "SI");
  is.field("unit", &TuneResult::dimension, "SI unit of the objective; null if unknown");
  is.field("start_objective", &TuneResult::start_objective, "objective at the start", "SI");
  is.field(
      "worst", [](const TuneResult& of) { return result::text_if_any(of.worst); },
      "run with the largest objective; null for a single run");
  is.field("targets", target_rows, "targets in the order of the file");
  is.field("singular_values", result::path(&TuneResult::resolution, &Resolution::singular_values),
           "singular values of the derivatives of the targets; below 1 a direction is free");
  is.field("claims", &TuneResult::claims, "claims of the section");
  is.field("starts", &TuneResult::starts, "searches");
  is.field("findings", &TuneResult::findings, "bounds, violated claims, failed evaluations");
  is.field("method", &TuneResult::method, "method of the search");
  is.field(
      "evaluations", [](const TuneResult& of) { return of.history.size(); }, "number of evaluations");
  is.field("failed_evaluations", &TuneResult::bad, "number of evaluations without an objective");
  is.field("runs", &TuneResult::runs, "number of runs per evaluation");
  is.field("feasible", &TuneResult::feasible, "true if all claims hold");
  is.field("converged", &TuneResult::converged, "true if the search converged");
  is.field("interrupted", &TuneResult::interrupted, "true if it was interrupted");
  is.field("compiled", &TuneResult::compiled, "true if runs were compiled");
  is.field("duration", &TuneResult::seconds, "duration of the optimisation", "s");
}

}  // namespace stepwire::tuning
