#include "engine/app/session/outcome.hpp"

#include <chrono>
#include <limits>

#include "engine/view/scene/scene_states.hpp"

namespace stepwire::session {

namespace {

claim::Verdict not_judged(const claim::Claim& claim, const std::string& why) {
  claim::Verdict verdict;
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
    scene::add_scene_states(*model.scene, outcome.shown);
  }
  for (const claim::Claim& claim : model.claims)
    outcome.verdicts.push_back(early ? not_judged(claim, "the run ended early")
                                     : claim::judge(claim, outcome.recordings()));
}

Outcome run_model(const LoadedModel& model, const run::RunOptions& options) {
  Outcome outcome;
  const auto start = std::chrono::steady_clock::now();
  outcome.result = run::run_job(model.job, options);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  judge_claims(model, outcome);
  return outcome;
}

Outcome run_model(const LoadedModel& model, run::ExecutionMode engine, plan::CodeSource& code,
                  const Monitor& monitor) {
  run::RunOptions options;
  options.engine = engine;
  options.code = &code;
  options.interrupt = monitor.interrupt;
  options.progress = [&](double fraction) { monitor.show(fraction); };
  options.observers = monitor.observers;
  return run_model(model, options);
}

}  // namespace stepwire::session
