#include "engine/app/session/outcome.hpp"

#include <chrono>
#include <limits>

#include "engine/view/scene/scene_states.hpp"

namespace stepwire {

namespace {

Verdict not_judged(const Claim& claim, const std::string& why) {
  Verdict verdict;
  verdict.kind = claim.kind;
  verdict.that = claim.that;
  verdict.check = claim.check;
  verdict.value = std::numeric_limits<double>::quiet_NaN();
  verdict.shown = "none";
  verdict.disagrees = claim.disagrees;
  verdict.note = why;
  return verdict;
}

}  // namespace

void judge_claims(const LoadedModel& model, Outcome& outcome) {
  const bool early = outcome.early();
  if (model.scene && !early) {
    outcome.shown = outcome.result.recordings;
    add_scene_states(*model.scene, outcome.shown);
  }
  for (const Claim& claim : model.claims)
    outcome.verdicts.push_back(early ? not_judged(claim, "the run ended early")
                                     : judge(claim, outcome.recordings()));
}

Outcome run_model(const LoadedModel& model, const RunOptions& options) {
  Outcome outcome;
  const auto start = std::chrono::steady_clock::now();
  outcome.result = run_job(model.job, options);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  judge_claims(model, outcome);
  return outcome;
}

Outcome run_model(const LoadedModel& model, ExecutionMode engine, CodeSource& code, const Monitor& monitor) {
  RunOptions options;
  options.engine = engine;
  options.code = &code;
  options.interrupt = monitor.interrupt;
  options.progress = [&](double fraction) { monitor.show(fraction); };
  options.observers = monitor.observers;
  return run_model(model, options);
}

}  // namespace stepwire
