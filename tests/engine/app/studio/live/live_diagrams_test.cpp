// Diagrams of the project under a page: what is seen of them live is what `run` gives.
#include <cmath>
#include <filesystem>

#include "engine/app/session/session.hpp"
#include "engine/app/studio/live/recorded_so_far.hpp"
#include "engine/app/studio/live/run_results.hpp"
#include "tests/engine/app/studio/live/waiting.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::live {

namespace {

const std::string diagrams = STEPWIRE_SOURCE_DIR "/diagrams/";

}  // namespace

TEST_CASE("what was recorded live has the bits of a run, for diagrams of all sorts") {
  for (const std::string name :
       {"examples/01-first-diagram", "examples/05-vectors", "examples/15-sample-times",
        "examples/16-discrete-only", "examples/18-record", "examples/19-stop-when",
        "examples/22-pid-anti-windup", "examples/23-state-machine", "examples/27-noise",
        "examples/53-real-time-loop", "examples/82-scene"}) {
    INFO(name);
    session::Session session(library());
    session::LoadedModel model = session.load(diagrams + name + ".yaml");
    const run::RunResult right = run::run_plan(model.job.plan);
    LoadedRun live(std::move(model), simulated());
    live.thread().play(0.0);
    wait_for_end(live.thread());
    const auto recordings = recorded_so_far(live.model(), live.signals(), live.thread(), true);
    REQUIRE(recordings.size() == right.recordings.size());
    for (std::size_t r = 0; r < recordings.size(); ++r) {
      const std::size_t swept = recordings[r].table.columns.size() - right.recordings[r].table.columns.size();
      REQUIRE(recordings[r].table.rows() == right.recordings[r].table.rows());
      for (std::size_t c = 0; c < right.recordings[r].table.columns.size(); ++c)
        CHECK(recordings[r].table.columns[c == 0 ? 0 : c + swept].values ==
              right.recordings[r].table.columns[c].values);
    }
  }
}

TEST_CASE("each example can be loaded, watched for some ticks and drawn", "[full]") {
  for (const auto& entry : std::filesystem::directory_iterator(diagrams + "examples")) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string name = entry.path().filename().string();
    if (name >= "60" && name < "63") continue;  // have no signals before their fit
    INFO(name);
    session::Session session(library());
    std::optional<session::LoadedModel> model;
    try {
      model = session.load(entry.path().string());
    } catch (const std::exception& error) {  // such as records that are not here
      WARN(name << ": " << error.what());
      continue;
    }
    LoadedRun live(std::move(*model), simulated());
    for (int i = 0; i < 3; ++i) live.thread().one_tick();
    CHECK(figures_now(live).find("figures")->items().size() == live.model().figures.size());
    CHECK(claims_now(live).find("claims")->items().size() == live.model().claims.size());
  }
}

TEST_CASE("of a sweep that keeps numbers a run that is watched has its own numbers, and claims judge them") {
  const Scratch folder;
  folder.file(
      "lag.yaml",
      "stepwire: 1\ntitle: t\nstep: 1 ms\nstop: 500 ms\nsolver: rk4\nparameters: {tau: 20 ms}\n"
      "record: lag\nblocks:\n  lag: {block: Lag, tau: $tau, u: 1}\n"
      "sweep: {tau: [10 ms, 20 ms], keep: {rise: rise_time(lag), end: final(lag)}}\n"
      "figure: {plot: xy, x: tau in ms, y: rise in ms}\n"
      "claims: [{that: a, max: abs(rise - log(9)*tau), at_most: 10 us}, {that: b, min: end, at_least: 1}]\n");
  session::Session session(library());
  LoadedRun live(session.load(folder.path("lag.yaml")), simulated());
  live.thread().play(0.0);
  wait_for_end(live.thread());
  const auto recordings = recorded_so_far(live.model(), live.signals(), live.thread(), true);
  REQUIRE(recordings.size() == 1);
  const table::Table& row = recordings.front().table;
  REQUIRE(row.rows() == 1);
  CHECK(row.find("tau")->values.front() == 0.02);
  CHECK(row.find("time")->values.front() == 0.5);
  CHECK(row.find("rise")->values.front() == Approx(0.02 * std::log(9.0)).epsilon(1e-3));
  const json::Json claims = claims_now(live);
  CHECK(*claims.find("claims")->items()[0].find("verdict")->as_text() == "ok");
  CHECK(*claims.find("claims")->items()[1].find("verdict")->as_text() == "FAIL");
  CHECK(figures_now(live).find("figures")->items().front().find("fault") == nullptr);
}

}  // namespace stepwire::live
