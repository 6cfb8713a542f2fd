// The files that a live run writes are replayed bit by bit.
#include "engine/app/studio/live/live_folder.hpp"

#include "engine/base/io/file.hpp"
#include "tests/engine/app/cli/program.hpp"
#include "tests/engine/app/studio/live/live_studio.hpp"

namespace stepwire::live {

namespace {

const std::string geared = R"(stepwire: 1
title: Values that follow from others
step: 1 ms
stop: 2 s
solver: rk4
parameters:
  mass: {value: 2 kg, above: 0 kg, at_most: 9 kg}
  twice: = 2 * mass
inputs: {push: {unit: N, default: 1 N}}
record:
  - {every: 10 ms, signals: [slide.position]}
  - {signals: [net, rig.y]}
blocks:
  spring: {block: Gain, u: slide.position, gain: -100 N/m}
  net: {block: Sum, u: [push, spring]}
  slide: {block: Mass, force: net, mass: $twice}
  rig: {diagram: rig.yaml, u: net, tau: = 0.01 s/kg * mass}
)";
const std::string rig_part = R"(stepwire: 1
parameters: {tau: {value: 20 ms}}
inputs: {u: {}}
outputs: {y: lag}
blocks: {lag: {block: Lag, u: u, tau: $tau}}
)";

struct Kept {
  Kept() : out(scratch.path("out")) {
    scratch.file("rig.yaml", rig_part);
    const std::string file = scratch.file("geared.yaml", geared);
    run.emplace(
        [file](int, bool) {
          diagram::Loader loader(library());
          return session::load_model(loader, file, {});
        },
        received.sinks(), LiveOptions{{}, out});
    call("run.load", R"({"file": 1})");
  }
  Json call(const std::string& name, const std::string& arguments = "{}") {
    return run->call(1, name, Json::parse(arguments));
  }
  void seek(double time) {
    const double tick = *call("run.seek", fmt::format(R"({{"time": {}}})", time)).find("tick")->as_number();
    wait_until([&] {
      const auto news = received.last("run");
      return news && *news->find("tick")->as_number() == tick && *news->find("state")->as_text() != "playing";
    });
  }
  void set(const std::string& name, const std::string& text) {
    call("run.set", fmt::format(R"({{"name": "{}", "value": "{}"}})", name, text));
  }
  void push(double value) {
    call("run.input",
         fmt::format(R"({{"samples": [{{"time": 0, "name": "push", "values": [{}]}}]}})", value));
  }
  std::string verified() const { return replay::verification_text(verify_live(out, library())); }

  Scratch scratch;
  std::string out;
  Received received;
  std::optional<LiveRun> run;
};

}  // namespace

TEST_CASE("a live run with values, inputs and returns to earlier moments is replayed bit by bit") {
  Kept kept;
  kept.set("mass", "1 kg");
  kept.seek(0.3);
  kept.set("mass", "3 kg");
  kept.push(4.0);
  kept.seek(0.9);
  kept.set("spring.gain", "-50 N/m");
  kept.set("rig.tau", "7 ms");
  kept.push(-2.0);
  kept.seek(1.4);
  kept.seek(0.5);  // back
  kept.set("mass", "5 kg");
  kept.seek(1.2);
  kept.call("run.keep");
  CHECK(is_live_folder(kept.out));
  CHECK_THAT(kept.verified(), Catch::StartsWith("3 signals in") && Catch::Contains("all bits agree"));
  CHECK_THAT(io::read_file(kept.out + "/live.json"), Catch::Contains("\"push\""));
  const Done done = run_program(kept.scratch, {"verify", kept.out});
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Catch::Contains("all bits agree; the run ended early"));
}

TEST_CASE("a run to its end is kept whole, and a later one takes its place") {
  Kept kept;
  kept.call("run.play", R"({"rate": 0})");
  wait_until([&] {
    const auto news = kept.received.last("run");
    return news && *news->find("state")->as_text() == "ended";
  });
  kept.call("run.keep");
  CHECK(kept.verified() == "3 signals in 2202 rows: all bits agree");
  kept.call("run.restart");
  kept.set("mass", "4 kg");
  kept.seek(0.1);
  kept.call("run.keep");
  CHECK_THAT(kept.verified(), Catch::Contains("all bits agree; the run ended early"));
}

TEST_CASE("without a folder a run is kept beside its diagram, under its name") {
  CHECK(folder_beside("rig/cart.yaml") == "rig/cart-run");
  CHECK(folder_beside("/rigs/a.b/two.parts.yaml") == "/rigs/a.b/two.parts-run");
}

TEST_CASE("a log or a sample that was changed is found") {
  Kept kept;
  kept.seek(0.3);
  kept.set("mass", "3 kg");
  kept.seek(0.6);
  kept.call("run.keep");
  const std::string log = io::read_file(kept.out + "/live.json");
  std::string other = log;
  REQUIRE(other.find("\"tick\": 301") != std::string::npos);
  other.replace(other.find("\"tick\": 301"), 11, "\"tick\": 302");
  io::write_file(kept.out + "/live.json", other);
  CHECK_THAT(kept.verified(), Catch::Contains("is replayed"));
  for (const char* broken :
       {"{", "[]", R"({"events": [{"tick": 1, "name": "mass", "blocks": [{}]}], "lost": 0})",
        R"({"events": [], "lost": 3})"}) {
    io::write_file(kept.out + "/live.json", broken);
    CHECK_THROWS_AS(verify_live(kept.out, library()), yaml::Error);
  }
}

TEST_CASE("a real-time loop is replayed bit by bit, beyond the file's stop", "[full]") {
  const Scratch scratch;
  session::LoopWords words;
  words.policy = "other";
  Studio studio(swing, session::read_loop_settings(words), scratch.path("out"));
  studio.call("run.load", R"({"file": 1})");
  studio.call("run.play", R"({"rate": 1})");
  const auto tick = [&] {
    const auto news = studio.received.last("run");
    return news ? *news->find("tick")->as_number() : 0.0;
  };
  wait_until([&] { return tick() > 100; });
  studio.call("run.set", R"({"name": "mass", "value": "3 kg"})");
  studio.call("run.input", R"({"samples": [{"time": 0, "name": "push", "values": [5]}]})");
  wait_until([&] { return tick() > 3100; });
  studio.call("run.keep");
  CHECK_THAT(replay::verification_text(verify_live(scratch.path("out"), library())),
             Catch::Contains("all bits agree"));
}

}  // namespace stepwire::live
