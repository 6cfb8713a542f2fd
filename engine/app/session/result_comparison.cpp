#include "engine/app/session/result_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stepwire::session {

namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& message) {
  throw yaml::Error(yaml::Fault{{file, {}}, "", message, {}});
}

Outcome run_of(Session& session, const std::string& file) {
  const LoadedModel model = session.load(file);
  if (model.study || model.fit)
    refuse(file, "has a section 'study' or 'fit'; compare the folders of their runs by 'stepwire compare'");
  Outcome outcome = session.run(model);
  if (!outcome.result.faults.empty()) throw yaml::Error(outcome.result.faults.front().fault);
  return outcome;
}

std::vector<const table::Table*> tables_of(const Outcome& outcome) {
  std::vector<const table::Table*> tables;
  for (const record::Recording& recording : outcome.recordings()) tables.push_back(&recording.table);
  return tables;
}

const claim::Verdict* verdict_of(const Outcome& outcome, const std::string& that) {
  const auto found = std::ranges::find(outcome.verdicts, that, &claim::Verdict::that);
  return found == outcome.verdicts.end() ? nullptr : &*found;
}

std::string text_of(const claim::Verdict* verdict) {
  if (!verdict) return "absent";
  return verdict->shown.empty() ? verdict->word() : fmt::format("{}: {}", verdict->word(), verdict->shown);
}

/// Adds the claims of one outcome whose verdict is another one in the other outcome.
void add_changes(const Outcome& before, const Outcome& after, std::vector<ChangedVerdict>& changes) {
  for (const claim::Verdict& old : before.verdicts) {
    const claim::Verdict* now = verdict_of(after, old.that);
    if (!now || now->word() != old.word()) changes.push_back({old.that, text_of(&old), text_of(now)});
  }
  for (const claim::Verdict& now : after.verdicts)
    if (!verdict_of(before, now.that)) changes.push_back({now.that, text_of(nullptr), text_of(&now)});
}

}  // namespace

ResultComparison compare_results(Session& session, const std::string& before, const std::string& after) {
  const Outcome old = run_of(session, before), now = run_of(session, after);
  ResultComparison result{comparison::compare(tables_of(old), tables_of(now), {}), {}};
  result.signals.a = before;
  result.signals.b = after;
  if (!result.signals.faults.empty()) refuse(after, result.signals.faults.front());
  add_changes(old, now, result.claims);
  return result;
}

static void declare(result::Record<ChangedVerdict>& is) {
  is.named("ChangedVerdict", "Claim with different verdicts in the runs of two diagrams.");
  is.field("that", &ChangedVerdict::that, "the claim");
  is.field("before", &ChangedVerdict::before, "verdict and value of the old diagram, or absent");
  is.field("after", &ChangedVerdict::after, "verdict and value of the new diagram, or absent");
}

void declare(result::Record<ResultComparison>& is) {
  is.named("ResultComparison", "Differences between the runs of two diagrams.");
  is.field("agree", &ResultComparison::agrees, "true if signals and verdicts are the same");
  is.field("signals", &ResultComparison::signals, "differences of signals");
  is.field("claims", &ResultComparison::claims, "claims with another verdict");
}

}  // namespace stepwire::session
