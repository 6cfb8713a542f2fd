// Compiled code in a live run: it takes over during the run, and remains in use when values are set.
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "tests/engine/app/studio/live/waiting.hpp"

namespace stepwire::live {

namespace {

const std::string lag = R"(stepwire: 1
title: t
step: 1 ms
stop: 40 h
solver: rk4
parameters: {tau: {value: 20 ms, above: 0 s}}
record: [lag]
blocks:
  wave: {block: Sine, amplitude: 2, frequency: 3 Hz}
  twice: {block: Gain, u: wave, gain: 2}
  lag: {block: Lag, u: twice, tau: $tau}
)";

void wait_until_compiled(RunThread& run) {
  wait_until([&] { return run.status().compiled; });
}

}  // namespace

TEST_CASE("a live run goes over to compiled code and stays there while parameters are set") {
  diagram::Loader loader(library());
  const plan::Plan plan = plan::make_plan(loader.load_text(lag, "lag.yaml"));
  const SignalList signals(plan);
  codegen::GeneratedCode code{run::code_trial()};
  RunThread::Options options;
  options.code = &code;
  RunThread run(plan, signals, options);
  run.set("tau", "30 ms");
  run.play(10.0);
  wait_until_compiled(run);
  run.set("tau", "10 ms");
  CHECK(run.status().compiled);
  run.set("twice.gain", "3");  // a constant of the code, which is compiled again
  wait_until_compiled(run);
  run.set("twice.gain", "2.5");
  CHECK(run.status().compiled);
  run.one_tick();
  const EventLog log = run.log();
  const std::int64_t end = run.store().end_tick();
  REQUIRE(end > log.events().back().tick);

  LogReplay replay(log);
  run::RunObserver* const observer = &replay;
  std::vector<record::Recorder> none;
  run::Executor again(plan);
  replay.begin({0, again});
  std::vector<double> live(4096);
  for (std::int64_t tick = 0; tick < end; ++tick) {
    observer->before_tick({0, again});
    again.evaluate();
    if (tick % 4096 == 0) run.store().read(0, tick, live);
    REQUIRE(live[static_cast<std::size_t>(tick % 4096)] == again.values()[signals.all()[0].offset]);
    again.advance();
  }
}

}  // namespace stepwire::live
