// Work of other processes for a study, a fit and an optimisation, sent as bytes and done in another order.
#include <catch2/catch.hpp>

#include "blocks/register.hpp"
#include "engine/app/cluster/kept_items.hpp"
#include "engine/app/cluster/shared_job.hpp"
#include "engine/app/session/session.hpp"
#include "engine/app/session/signal_files.hpp"
#include "tests/engine/app/cli/small_study.hpp"

namespace stepwire::cluster {

namespace {

const Registry& library() {
  static const Registry registry = blocks();
  return registry;
}

/// Does the last item first.
class Backwards : public messages::ItemWorkers {
 public:
  explicit Backwards(messages::ItemWork work) : work_(std::move(work)) {}

  std::vector<std::string> run(const std::vector<messages::Item>& items) override {
    std::vector<std::string> results(items.size());
    for (std::size_t i = items.size(); i-- > 0;) results[i] = work_(items[i]);
    count += items.size();
    return results;
  }

  std::size_t count = 0;

 private:
  messages::ItemWork work_;
};

session::LoadedModel loaded(const Scratch& folder, const std::string& text) {
  return session::Session(library()).load(folder.file("file.yaml", text));
}

/// A lag that is looked for beside the truth, by a section of the file.
std::string search_yaml(const std::string& section) {
  return R"(stepwire: 1
title: A lag is looked for
step: 10 ms
stop: 2 s
solver: rk4
parameters:
  tau: {value: 1 s, above: 0 s, doc: x}
  gain: {value: 3, doc: x}
blocks:
  sine: {block: Sine, frequency: 1 Hz}
  truth: {block: Lag, u: sine, tau: 0.2 s, gain: 2}
  lag: {block: Lag, u: sine, tau: $tau, gain: $gain}
record: [lag, truth]
)" + section;
}

/// Tables and errors of a study, and the model's number of items.
std::string study_text(session::LoadedModel& model, messages::ItemWorkers* workers) {
  session::Session session(library());
  session::StudyCall call{run::ExecutionMode::interpreted};
  call.workers = workers;
  const auto experiments = session.study(model, call);
  const session::Outcome outcome = session::study_outcome(model, *experiments);
  std::string text = result::json_of(session::StudyReport{&model, experiments.get()}).text();
  for (const session::StudyFile& file : session::study_texts(model, *experiments, outcome)) text += file.text;
  for (const record::Recording& recording : outcome.result.recordings)
    text += session::signals_csv(recording);
  return text;
}

void check_study(const std::string& text, std::size_t items) {
  const Scratch folder;
  session::LoadedModel alone = loaded(folder, text), by_others = loaded(folder, text);
  const session::LoadedModel at_work = loaded(folder, text);
  Backwards workers(session::study_work(library(), at_work, {run::ExecutionMode::interpreted, 1}));
  const std::string found = study_text(by_others, &workers);
  CHECK(workers.count == items);
  CHECK(found == study_text(alone, nullptr));
}

}  // namespace

TEST_CASE("people of a study, and experiments with others, are the same done elsewhere") {
  check_study(replaced(small_study(), "  seed: 1\n", "  seed: 1\n  experiments: 3\n"), 6 + 2);
}

TEST_CASE("people of a study are the same elsewhere at each point of a sweep") {
  const std::string text = replaced(small_study(), "  - {plot: table, of: anova}\n", "");
  check_study(replaced(text, "study:\n", "sweep: {step: [10 ms, 5 ms]}\nstudy:\n"), 2 * 6);
}

TEST_CASE("people who practise and carry something from trial to trial do so elsewhere, too") {
  check_study(content_of(STEPWIRE_SOURCE_DIR "/diagrams/examples/83-what-is-carried.yaml"), 6);
}

TEST_CASE("searches of a fit find the same elsewhere") {
  const Scratch folder;
  const session::LoadedModel model = loaded(folder, search_yaml(R"(fit:
  parameters: {tau: {start: 1 s, bounds: [10 ms, 10 s]}, gain: {start: 3, bounds: [0.1, 10]}}
  compare: [{model: lag, measured: truth}]
  starts: 5
  follow: 3
)"));
  session::FitCall call;
  call.threads = 1;
  session::Session session(library());
  const estimation::FitResult alone = session.fit(model, call);
  Backwards workers(session::fit_work(library(), model, call));
  call.workers = &workers;
  const estimation::FitResult by_others = session.fit(model, call);
  CHECK(workers.count >= 5);
  CHECK(workers.count <= session::most_searches(model, call));
  CHECK(session::parameters_text(alone) == session::parameters_text(by_others));
  REQUIRE(alone.starts.size() == by_others.starts.size());
  for (std::size_t i = 0; i < alone.starts.size(); ++i) {
    CHECK(alone.starts[i].cost == by_others.starts[i].cost);
    CHECK(alone.starts[i].iterations == by_others.starts[i].iterations);
  }
}

TEST_CASE("searches of a tuning look at the same points elsewhere") {
  const Scratch folder;
  const session::LoadedModel model = loaded(folder, search_yaml(R"(tune:
  parameters: {tau: {from: 10 ms, to: 10 s}, gain: {from: 0.1, to: 10}}
  minimise: rms(lag - truth)
  subject_to: [{that: it is no larger, max: abs(lag), at_most: 2.5}]
  starts: 3
  evaluations: 30
)"));
  session::TuneCall call;
  call.threads = 1;
  session::Session session(library());
  const std::string alone = session::history_csv(model, session.tune(model, call));
  Backwards workers(session::tune_work(library(), model, call));
  call.workers = &workers;
  CHECK(session::history_csv(model, session.tune(model, call)) == alone);
  CHECK(workers.count == 3);
}

TEST_CASE("what a job is comes to other processes whole, or not at all") {
  SharedJob job{SharedJob::Kind::fit, {{"tau", "2 s", "a.yaml", {3, 4}}}, {{}, {{"k", "1", "", {}}}}};
  const std::string bytes = bytes_of(job);
  const auto read = job_of(std::string_view(bytes));
  REQUIRE(read);
  CHECK(bytes_of(*read) == bytes);
  CHECK(read->settings.front().mark.column == 4);
  CHECK(read->of_points.back().front().name == "k");
  CHECK_FALSE(job_of(std::string_view(bytes).substr(0, bytes.size() - 1)));
}

TEST_CASE("items that are kept are not done again, and give what was sent") {
  const Scratch folder;
  const std::string path = folder.path("a.journal");
  const std::vector<messages::Item> items{{0}, {1}, {2}};
  {
    KeptItems kept(path, "head", 3);
    kept.want(items);
    CHECK(kept.left() == 3);
    kept.take(1, KeptItems::record_of(1, "one"));
    kept.take(0, KeptItems::record_of(0, ""));
  }
  KeptItems kept(path, "head", 3);
  CHECK(kept.kept() == 2);
  kept.want(items);
  CHECK(kept.next()->number == 2);
  CHECK_FALSE(kept.next());
  kept.take(2, KeptItems::record_of(2, "two"));
  CHECK(kept.results(items) == std::vector<std::string>{"", "one", "two"});
  CHECK(kept.results({{2}, {1}}) == std::vector<std::string>{"two", "one"});
  CHECK(KeptItems(path, "another head", 3).kept() == 0);
}

}  // namespace stepwire::cluster
