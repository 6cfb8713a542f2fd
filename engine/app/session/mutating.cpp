#include "engine/app/session/mutating.hpp"

#include <algorithm>
#include <atomic>

#include "engine/app/session/session.hpp"
#include "engine/base/parallel/parallel.hpp"

namespace stepwire::session {

namespace {

[[noreturn]] void refuse_mutations(const std::string& file, const std::string& message) {
  throw yaml::Error(yaml::Fault{{file, {}}, "", message, {}});
}

/// Runs of a file and its wrong versions.
class Mutator {
 public:
  Mutator(const Registry& registry, const std::string& file, const LoadOptions& options,
          const Monitor& monitor)
      : registry_(registry),
        options_(options),
        monitor_(monitor),
        model_(load_model(registry, file, options)) {
    options_.threads = 1;
    if (model_.study || model_.fit)
      refuse_mutations(file, "has a section 'study' or 'fit', whose runs are not mutated; leave it out");
    if (model_.claims.empty())
      refuse_mutations(file, "has no claims that could notice anything; add 'claims'");
    base_ = run(model_);
    for (const claim::Verdict& verdict : base_.verdicts)
      if (verdict.fails() || verdict.surprises())
        refuse_mutations(file, "does not pass as it is: " + verdict.that + "; mend it first");
  }

  const LoadedModel& model() const { return model_; }

  TriedMutation tried(const Mutation& mutation) {
    TriedMutation found{mutation.kind, mutation.what, mutation.old, "", MutationOutcome::refused};
    for (const Mutation::Version& version : mutation.versions) {
      found.version = version.text;
      try {
        const Outcome outcome = version.figure ? redrawn(*version.figure) : run_of(version);
        judge(outcome, found);
        return found;
      } catch (const yaml::Error& error) {
        found.by = error.faults().front().text();
      }
    }
    return found;
  }

 private:
  Outcome run(const LoadedModel& model) {
    Session session(registry_, {monitor_.interrupt, {}, {}, {}});
    Outcome outcome = session.run(model, run::ExecutionMode::interpreted, 1);
    if (!outcome.result.faults.empty() && &model == &model_)
      throw yaml::Error(outcome.result.faults.front().fault);
    return outcome;
  }

  Outcome run_of(const Mutation::Version& version) {
    LoadOptions options = options_;
    if (version.setting) options.settings.push_back(*version.setting);
    if (version.document)
      options.reader = [&](const std::string& path, const yaml::DocumentLimits& limits) {
        return path == model_.file
                   ? version.document
                   : std::make_shared<const yaml::Document>(yaml::read_document(path, limits));
      };
    return run(load_model(registry_, model_.file, options));
  }

  /// Returns the verdicts on the run as it is, with another figure.
  Outcome redrawn(const yaml::Node& figure) {
    LoadOptions options = options_;
    options.figure = figure;
    const LoadedModel model = load_model(registry_, model_.file, options);
    Outcome outcome = base_;
    judge_again(model, outcome);
    return outcome;
  }

  static void judge(const Outcome& outcome, TriedMutation& found) {
    found.outcome = MutationOutcome::survives;
    found.by.clear();
    const auto fails = [](const claim::Verdict& verdict) { return verdict.fails() || verdict.surprises(); };
    const auto failed = std::ranges::find_if(outcome.verdicts, fails);
    const bool faulty = !outcome.result.faults.empty();
    if (!faulty && failed == outcome.verdicts.end()) return;
    found.outcome = MutationOutcome::noticed;
    found.by = faulty ? outcome.result.faults.front().fault.text() : failed->that;
  }

  const Registry& registry_;
  LoadOptions options_;
  const Monitor& monitor_;
  const LoadedModel model_;
  Outcome base_;
};

const char* outcome_name(MutationOutcome outcome) {
  return outcome == MutationOutcome::noticed    ? "noticed"
         : outcome == MutationOutcome::survives ? "survives"
                                                : "refused";
}

}  // namespace

std::size_t MutationResult::count(MutationOutcome outcome) const {
  return static_cast<std::size_t>(std::ranges::count(mutations, outcome, &TriedMutation::outcome));
}

MutationResult mutate(const Registry& registry, const std::string& file, const LoadOptions& options,
                      const Monitor& monitor, unsigned threads) {
  Mutator mutator(registry, file, options, monitor);
  const auto [mutations, left_out] = mutations_of(mutator.model());
  MutationResult result{file, mutator.model().claims.size()};
  result.left_out = left_out;
  result.mutations.resize(mutations.size());
  std::vector<char> done(mutations.size(), 0);
  std::atomic<std::size_t> count = 0;
  parallel::in_parallel(mutations.size(), threads, [&, &mutations = mutations](std::size_t i) {
    if (monitor.interrupted()) return;
    result.mutations[i] = mutator.tried(mutations[i]);
    done[i] = monitor.interrupted() ? 0 : 1;
    monitor.show(static_cast<double>(++count) / static_cast<double>(mutations.size()));
  });
  result.interrupted = monitor.interrupted();
  if (!result.interrupted) return result;
  std::vector<TriedMutation> kept;  // those that an interruption has cut off are of no use
  for (std::size_t i = 0; i < done.size(); ++i)
    if (done[i]) kept.push_back(std::move(result.mutations[i]));
  result.mutations = std::move(kept);
  return result;
}

static void declare(result::Record<TriedMutation>& is) {
  is.named("TriedMutation", "Wrong version of a file, and whether its claims notice it.");
  is.field(
      "kind", [](const TriedMutation& of) { return kind_name(of.kind); }, "parameter, wire or drawn");
  is.field("what", &TriedMutation::what, "parameter, wire, or signal of a figure");
  is.field("old", &TriedMutation::old, "value, source or signal as written");
  is.field("version", &TriedMutation::version, "the same in the wrong version");
  is.field(
      "outcome", [](const TriedMutation& of) { return outcome_name(of.outcome); },
      "noticed, survives or refused");
  is.field("by", &TriedMutation::by, "first claim that fails, or the fault; empty without one");
}

void declare(result::Record<MutationResult>& is) {
  is.named("Mutations", "Wrong versions of a file, and which its claims notice: mutate.");
  is.field("file", &MutationResult::file, "diagram file");
  is.field("claims", &MutationResult::claims, "number of its claims and invariants");
  is.field("noticed", &MutationResult::noticed, "number of mutations after which a claim fails");
  is.field("survived", &MutationResult::survived, "number of those after which all claims hold");
  is.field("refused", &MutationResult::refused, "number of those that the file refuses");
  is.field("interrupted", &MutationResult::interrupted, "true if not all were tried");
  is.field("mutations", &MutationResult::mutations, "all mutations");
  is.field("left_out", &MutationResult::left_out, "parameters without mutations, each with the reason");
}

}  // namespace stepwire::session
