// Fixed steps of an explicit solver that are far too long.
#include <catch2/catch.hpp>
#include <string>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/run.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

std::string message_of(const std::string& text) {
  const RunResult result = result_of(text);
  return result.faults.empty() ? "" : result.faults.front().fault.text();
}

std::string lag(const std::string& solver, const std::string& step) {
  return "blocks:\n  u: {block: Step, time: 0.1 s}\n  lag: {block: Lag, tau: 1 ms, u: u}\nsolver: " + solver +
         "\nstep: " + step + "\nstop: 0.5 s\nrecord: lag\n";
}

}  // namespace

TEST_CASE("a run ends with a sentence where only its steps make a state grow") {
  // Limits of stability on the real axis: Hairer and Wanner II, IV.2.
  const std::pair<const char*, const char*> limits[] = {{"euler", "0.002 s"},
                                                        {"heun", "0.002 s"},
                                                        {"bogacki_shampine", "0.0025 s"},
                                                        {"rk4", "0.0027 s"},
                                                        {"dormand_prince", "0.0033 s"}};
  for (const auto& [solver, limit] : limits) {
    INFO(solver);
    const std::string message = message_of(lag(solver, "5 ms"));
    CHECK_THAT(message, Catch::Contains("lag.x: ") &&
                            Catch::Contains(std::string("A step of at most ") + limit) &&
                            Catch::Contains(solver));
  }
}

TEST_CASE("steps that are short enough end no run") {
  for (const char* solver : {"euler", "heun", "bogacki_shampine", "rk4", "dormand_prince"})
    CHECK(message_of(lag(solver, "1 ms")) == "");
}

TEST_CASE("what grows in the equations ends no run") {
  CHECK(message_of("blocks:\n  rate: {block: Gain, gain: 1 1/s, u: x}\n  x: {block: Integrator, u: rate, "
                   "initial: 1}\nsolver: euler\nstep: 1 s\nstop: 60 s\n"
                   "record: x\n") == "");
}

TEST_CASE("what a sampled controller makes grow ends no run") {
  CHECK(message_of(R"(blocks:
  control: {block: Gain, gain: -40, u: x, every: 0.1 s}
  rate: {block: Sum, u: [control, fade]}
  fade: {block: Gain, gain: -1, u: x}
  x: {block: Integrator, u: rate, initial: 1}
solver: rk4
step: 0.1 s
stop: 3 s
record: x
)") == "");
}

TEST_CASE("an oscillator that the method of Euler blows up is named, too") {
  const std::string message = message_of(R"(blocks:
  force: {block: Gain, gain: -100, u: x}
  v: {block: Integrator, u: force}
  x: {block: Integrator, u: v, initial: 1}
solver: euler
step: 0.1 s
stop: 10 s
record: x
)");
  CHECK_THAT(message, Catch::Contains("is wrong. A solver of higher order"));
}

TEST_CASE("the scale of a state does not matter") {
  for (const char* size : {"1e-7", "1e-3", "1", "1e6"}) {
    INFO(size);
    const std::string text = "blocks:\n  u: {block: Step, time: 0.1 s, after: " + std::string(size) +
                             "}\n  lag: {block: Lag, tau: 1.5 ms, u: u}\nsolver: rk4\n"
                             "step: 5 ms\nstop: 0.14 s\nrecord: lag\n";
    CHECK_THAT(message_of(text), Catch::Contains("lag.x: ") && Catch::Contains("A step of at most 0.0041 s"));
  }
}

TEST_CASE("a fast mode that is not excited ends no run, nor does a state that passes 0") {
  CHECK(message_of(R"(blocks:
  rest: {block: Lag, tau: 1 ms, u: 0}
  s: {block: Sine, frequency: 1 Hz}
  v: {block: Integrator, u: s}
  force: {block: Gain, gain: -39.478417604357434, u: x}
  w: {block: Integrator, u: force}
  x: {block: Integrator, u: w, initial: 1}
solver: rk4
step: 5 ms
stop: 1.25 s
record: [rest, v, x]
)") == "");
}

TEST_CASE("a part that is switched off, and a reset, hide no state that has grown") {
  const std::string head = "solver: rk4\nstep: 0.1 s\nstop: 10 s\nrecord: lag\nblocks:\n";
  for (const char* how : {"enable: time < 0.75 s", "reset: pulse", "enable: time > 1.3 s && time < 2.2 s"}) {
    INFO(how);
    const std::string message = message_of(
        head + "  pulse: {block: Pulse, period: 0.7 s, width: 0.1}\n  lag: {block: Lag, tau: 20 ms, u: 1, " +
        how + "}\n");
    CHECK_THAT(message, Catch::Contains("A step of at most 0.055 s"));  // 2.785 times 20 ms
  }
}

TEST_CASE("a lag whose rate is high for a while is found at a quarter of the run") {
  const std::string message = message_of(R"(blocks:
  rate: {block: Step, time: 3 s, before: -40, after: -1}
  fade: {block: Product, u: [rate, x]}
  x: {block: Integrator, u: fade, initial: 1}
solver: rk4
step: 0.1 s
stop: 10 s
record: x
)");
  CHECK_THAT(message, Catch::Contains("A step of at most 0.069 s"));  // 2.785/40
}

TEST_CASE("growth that doubles a state within the run is found, and slower growth is not") {
  // |R(i y)|^2 of dormand_prince is 1.0646 at y = 2, that of euler 1 + y^2.
  const auto oscillator = [](const std::string& solver, const std::string& step, const std::string& stop) {
    return message_of(
        "blocks:\n  force: {block: Gain, gain: -100, u: x}\n  v: {block: Integrator, u: force}\n"
        "  x: {block: Integrator, u: v, initial: 1}\nrecord: x\nsolver: " +
        solver + "\nstep: " + step + "\nstop: " + stop + "\n");
  };
  CHECK_THAT(oscillator("dormand_prince", "0.2 s", "30 s"), Catch::Contains("lets this state grow by 3.2 %"));
  CHECK(oscillator("dormand_prince", "0.2 s", "4 s") == "");  // 1.0318^20 = 1.87
  CHECK_THAT(oscillator("euler", "10 ms", "1.5 s"), Catch::Contains("lets this state grow by 0.5 %"));
  CHECK(oscillator("euler", "10 ms", "1.3 s") == "");  // 1.01^65 = 1.91
}

TEST_CASE("dry friction that changes its sign at each step ends no run") {
  // The body stops after 1 s and 0.5 m, to a step of its speed.
  for (const char* solver : {"euler", "heun", "bogacki_shampine"})
    for (const char* step : {"10 ms", "7.5 ms", "4 ms"}) {
      INFO(solver << " " << step);
      CHECK(message_of("blocks:\n  c: {block: Coulomb, u: m.velocity, coulomb: 1 N}\n  n: {block: Gain, u: "
                       "c, gain: -1}\n"
                       "  m: {block: Mass, mass: 1 kg, force: n, initial_velocity: 1 m/s}\nstop: 3 s\n"
                       "record: m.position\nsolver: " +
                       std::string(solver) + "\nstep: " + step + "\n") == "");
    }
}

TEST_CASE("runs of a sweep are judged alike in lanes and alone, at the same tick") {
  const DiagramFolder folder;
  folder.write(
      "sweep.yaml",
      "stepwire: 1\nparameters: {tau: 10 ms}\nsweep: {tau: [10 ms, 1 ms, 20 ms, 5 ms, 2 ms]}\nblocks:\n"
      "  u: {block: Step, time: 0.1 s}\n  lag: {block: Lag, tau: $tau, u: u}\nsolver: rk4\n"
      "step: 5 ms\nstop: 1 s\nrecord: lag\n");
  diagram::Loader loader(library());
  const Job job = make_job(loader, folder.path("sweep.yaml"));
  codegen::GeneratedCode code{code_trial()};
  std::vector<std::size_t> rows;
  for (const LaneUse lanes : {LaneUse::never, LaneUse::at_once}) {
    RunOptions options;
    options.engine = ExecutionMode::compiled;
    options.code = &code;
    options.lanes = lanes;
    const RunResult result = run_job(job, options);
    REQUIRE(result.faults.size() == 1);
    CHECK_THAT(result.faults.front().fault.text(), Catch::Contains("A step of at most 0.0027 s"));
    rows.push_back(result.recordings.front().table.columns.front().values.size());
  }
  CHECK(rows[0] == rows[1]);
}

}  // namespace stepwire::run
