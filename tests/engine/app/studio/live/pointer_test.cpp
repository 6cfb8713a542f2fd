// Scenes with a pointer, which replaces the hand of the file; the log reproduces the same bits.
#include "engine/app/studio/live/pointer.hpp"

#include "engine/app/session/session.hpp"
#include "engine/app/studio/live/live_run.hpp"
#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/app/studio/live/scene_now.hpp"
#include "tests/engine/app/studio/live/waiting.hpp"

namespace stepwire::live {

namespace {

const std::string diagrams = STEPWIRE_SOURCE_DIR "/diagrams/";

session::LoadedModel loaded(const std::string& name) {
  diagram::Loader loader(library());
  return load_for_page(loader, diagrams + name + ".yaml");
}

std::array<double, 2> shown(LoadedRun& run, const std::string& name) {
  std::array<double, 2> at{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto signal = run.signals().find(name + "." + std::to_string(i + 1));
    REQUIRE(signal);
    const std::size_t column = run.stored(*signal);
    run.store().read(column, run.store().end_tick() - 1, {&at[i], 1});
  }
  return at;
}

/// Sends a pointer position and `held`, as a page does, and runs to the time `until`.
void lead(LoadedRun& run, const std::array<double, 2>& to, double held, double until) {
  run.thread().input({1, 0.0, pointer_input, {to[0], to[1]}});
  run.thread().input({1, 0.0, held_input, {held}});
  const std::int64_t tick = run.thread().seek(until);
  wait_for_tick(run.thread(), tick);
}

struct Playable {
  std::string file, pin;
  std::array<double, 2> aim;
  double near;  ///< [m]
};

/// Returns the message with which `load` refuses a diagram with this `pointer` in its scene; empty if it
/// loads.
template <class Load>
std::string pointer_fault(const std::string& blocks, const std::string& pointer, const Load& load) {
  diagram::Loader loader(library());
  loader.add(yaml::parse_document("stepwire: 1\ntitle: t\nstep: 10 ms\nstop: 1 s\n" + blocks +
                                      "scene:\n  view: {x: [-5 mm, 5 mm], y: [-5 mm, 5 mm]}\n"
                                      "  objects: {ball: {ball: pen}}\n  pointer: " +
                                      pointer + "\n",
                                  "t.yaml"));
  try {
    load(loader);
  } catch (const yaml::Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("scenes of the thesis and of the exercise are led by a pointer, and replayed bit by bit") {
  const auto one =
      GENERATE(Playable{"thesis/fig38-virtual-environment-inside", "view.at", {0.230, 0.002}, 8e-3},
               Playable{"thesis/fig39-virtual-environment-outside", "view.at", {0.219, 0.002}, 8e-3},
               Playable{"thesis/fig40-circle-task", "task.rig.at", {0.236, 0.006}, 8e-3},
               Playable{"thesis/fig44-guiding-path", "task.position", {0.229, 0.020}, 8e-3},
               Playable{"examples/72-figure-of-eight", "rig.at", {0.228, -0.016}, 8e-3},
               Playable{"examples/82-scene", "pen", {0.004, -0.007}, 1e-12});
  INFO(one.file);
  LoadedRun run(loaded(one.file), simulated());
  run.stored(*run.signals().find(one.pin + ".1"));
  run.stored(*run.signals().find(one.pin + ".2"));
  run.thread().one_tick();
  const std::array<double, 2> start = shown(run, one.pin);
  const auto away = [&](const std::array<double, 2>& at) {
    return std::hypot(at[0] - one.aim[0], at[1] - one.aim[1]);
  };
  lead(run, one.aim, 0.0, 0.1);
  if (one.near > 1e-6)
    CHECK(std::hypot(shown(run, one.pin)[0] - start[0], shown(run, one.pin)[1] - start[1]) < 1e-4);
  for (int i = 1; i <= 10; ++i) {
    const double share = 0.1 * i;
    lead(run, {start[0] + share * (one.aim[0] - start[0]), start[1] + share * (one.aim[1] - start[1])}, 1.0,
         0.1 + 0.05 * i);
  }
  lead(run, one.aim, 1.0, 0.9);
  CHECK(away(shown(run, one.pin)) < one.near);
  if (one.near > 1e-6) CHECK(away(shown(run, one.pin)) < away(start));
  run.thread().release(1);
  run.thread().seek(1.0);
  wait_until([&] { return run.store().time_of(run.store().end_tick() - 1) == 1.0; });

  const session::LoadedModel again = loaded(one.file);
  LogReplay replay(run.thread().log());
  run::Executor simulation(again.job.plan);
  replay.begin({0, simulation});
  const std::int64_t end = run.store().end_tick();
  const LiveSignal& pin = run.signals().all()[*run.signals().find(one.pin + ".1")];
  std::vector<double> live(static_cast<std::size_t>(end));
  run.store().read(run.stored(*run.signals().find(one.pin + ".1")), 0, live);
  for (std::int64_t tick = 0; tick < end; ++tick) {
    replay.before_tick({0, simulation});
    simulation.evaluate();
    if (tick > 0) REQUIRE(live[static_cast<std::size_t>(tick)] == simulation.values()[pin.offset]);
    simulation.advance();
  }
}

TEST_CASE("a file without a pointer is loaded for a page as for anybody") {
  const session::LoadedModel model = loaded("examples/01-first-diagram");
  session::Session session(library());
  CHECK(model.hash == session.load(diagrams + "examples/01-first-diagram.yaml").hash);
  CHECK_FALSE(has_pointer(model.job.plan.diagram));
}

TEST_CASE("a pointer that names what is not there is refused at its place") {
  const auto fault_of = [](const std::string& pointer) {
    return pointer_fault(
        "blocks:\n  pen: {block: Constant, value: [1 mm, 2 mm]}\n"
        "  hot: {block: Constant, value: 3 K}\nrecord: [pen, hot]\n",
        pointer, [](diagram::Loader& loader) { load_for_page(loader, "t.yaml"); });
  };
  CHECK(fault_of("{place: pen}") == "");
  CHECK_THAT(fault_of("{place: pan}"),
             Catch::Contains("t.yaml:12:") && Catch::Contains("did you mean 'pen'"));
  CHECK_THAT(fault_of("{place: hot}"), Catch::Contains("is in K, and a pointer gives m"));
  CHECK_THAT(fault_of("{force: pen}"), Catch::Contains("'position' and 'velocity'"));
  CHECK_THAT(fault_of("{force: pen, place: pen}"), Catch::Contains("scene.pointer"));
  CHECK_THAT(fault_of("{motion: [pen], load: hot}"), Catch::Contains("three signals"));
  CHECK_THAT(fault_of("{plaze: pen}"), Catch::Contains("place"));
}

TEST_CASE("a scene with a pointer can be watched with the file's own hand") {
  LiveRun run(
      [](int, bool hand) -> Loading {
        diagram::Loader loader(library());
        const std::string file = diagrams + "examples/72-figure-of-eight.yaml";
        return hand ? load_for_page(loader, file) : session::load_model(loader, file, {});
      },
      {[](const json::Json&) {}, [](int, const std::string&) {}});
  const auto loaded = [&](const std::string& arguments) {
    run.call(1, "run.load", json::Json::parse(arguments));
    return run.call(1, "scene", {});
  };
  const json::Json led = loaded(R"({"file": 1})"), watched = loaded(R"({"file": 1, "hand": false})");
  CHECK(*led.find("scene")->find("pointer")->find("hand")->as_flag());
  CHECK_FALSE(*watched.find("scene")->find("pointer")->find("hand")->as_flag());
  CHECK(led.find("scene")->find("objects")->text() == watched.find("scene")->find("objects")->text());
  CHECK_THROWS(
      run.call(1, "run.input",
               json::Json::parse(R"({"samples": [{"time": 0, "name": "pointer", "values": [0, 0]}]})")));
}

TEST_CASE("names under 'pointer' are looked up by every load, each at its place") {
  const auto fault_of = [](const std::string& pointer) {
    return pointer_fault(
        "solver: rk4\nblocks:\n  pen: {block: Constant, value: [1 mm, 2 mm]}\n"
        "  lag: {block: Lag, u: pen, tau: 1 s}\nrecord: [pen]\n",
        pointer, [](diagram::Loader& loader) { session::load_model(loader, "t.yaml", {}); });
  };
  CHECK(fault_of("{place: lag}") == "");
  CHECK_THAT(fault_of("{place: pan}"),
             Catch::Contains("t.yaml:13:20: scene.pointer.place: there is no signal "
                             "'pan'; did you mean 'pen'?"));
  CHECK_THAT(fault_of("{force: lag, position: pam, velocity: pon}"),
             Catch::Contains("scene.pointer.position") && Catch::Contains("scene.pointer.velocity"));
  CHECK_THAT(fault_of("{motion: [pen, lag, lug], load: pen}"),
             Catch::Contains("scene.pointer.motion: there is no signal 'lug'"));
}

}  // namespace stepwire::live
