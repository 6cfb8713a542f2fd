#include <catch2/catch.hpp>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::run {

namespace {

/// Limits, zones and comparisons beside an oscillator that reaches none of them.
const std::string oscillator = R"(step: 1 ms
stop: 1 s
blocks:
  push:  {block: Sine, amplitude: 2, frequency: 1.1 Hz}
  limit: {block: Saturation, lower: -3, upper: 3, u: push}
  k:     {block: Gain, gain: 40, u: x}
  gap:   {block: DeadZone, lower: -5, upper: 5, u: k4}
  k4:    {block: Gain, gain: 0.01, u: k}
  a:     {block: Sum, signs: "+--", u: [limit, k, gap]}
  v:     {block: Integrator, u: a, lower: -100, upper: 100}
  x:     {block: Integrator, u: v, initial: 0.1}
  far:   {block: Compare, u: k4, operator: greater, to: 4}
record: [x, v, far]
)";

/// A controller with a period before a plant, so that what may cross hangs on what changes at ticks.
const std::string sampled = R"(step: 1 ms
stop: 1 s
blocks:
  error:   {block: Sum, signs: "+-", u: [1, plant], every: 4 ms}
  control: {block: Gain, gain: 3, u: error, every: 4 ms}
  drive:   {block: Sum, u: [control, plant]}
  limit:   {block: Saturation, lower: -50, upper: 50, u: drive}
  plant:   {block: Lag, tau: 80 ms, u: limit}
  alarm:   {block: Relay, switch_on: 40, switch_off: 30, u: limit}
record: [plant, limit, alarm]
)";

/// A loop that is solved at each instant, and a part of it that may be limited.
const std::string loop = R"(step: 1 ms
stop: 1 s
algebraic_loops: solve
blocks:
  y:     {block: Sum, signs: "+-", u: [x, bend]}
  bend:  {block: Expression, u: y, expression: 0.3*tanh(u)}
  limit: {block: Saturation, lower: -9, upper: 9, u: y}
  x:     {block: Integrator, u: rate, initial: 2}
  rate:  {block: Gain, gain: -1, u: limit}
record: [x, y]
)";

/// A block that is enabled all the time, and one that never is.
const std::string guarded = R"(step: 1 ms
stop: 1 s
blocks:
  on:   {block: Integrator, u: fall, initial: 1, enable: fall < 5}
  off:  {block: Integrator, u: on, initial: 1, enable: on > 5}
  fall: {block: Gain, gain: -2, u: on}
  top:  {block: Saturation, upper: 3, u: on}
stop_when: on < -1 || off > 2
record: [on, off, top]
)";

using Rows = std::vector<std::vector<double>>;

Rows rows_of(const plan::Plan& plan, const plan::CompiledPlan* code = nullptr) {
  Executor run(plan);
  if (code) run.use(*code);
  record::RunRecording recording(plan);
  for (bool last = false; !last; run.advance()) {
    run.evaluate();
    REQUIRE(run.healthy());
    last = run.finished();
    recording.recorders().front().record(run.tick(), run.values(), last);
  }
  Rows rows;
  const std::vector<record::Recording> recorded = recording.take();
  for (const table::Column& column : recorded.front().table.columns) rows.push_back(column.values);
  return rows;
}

}  // namespace

TEST_CASE("where nothing crosses, the bits are those of a run without events, with every solver") {
  for (const std::string& text : {oscillator, sampled, loop, guarded})
    for (const char* solver : {"euler", "rk4", "dormand_prince", "rosenbrock", "sdirk"}) {
      const std::string head = std::string("solver: ") + solver + "\n" + text;
      INFO(head);
      const plan::Plan located = plan_text("events: locate\n" + head);
      REQUIRE(located.crossing_count > 0);
      CHECK(rows_of(located) == rows_of(plan_text(head)));
    }
}

TEST_CASE("compiled code has the same bits where nothing crosses") {
  codegen::GeneratedCode source{run::code_trial()};
  for (const std::string& text : {oscillator, sampled, loop, guarded}) {
    const plan::Plan plan = plan_text("events: locate\nsolver: rk4\n" + text);
    const auto code = source.compile(plan, {}, {});
    INFO(source.take_problem());
    REQUIRE(code);
    CHECK(rows_of(plan, &*code) == rows_of(plan));
  }
}

TEST_CASE("what only the solver changes is computed once a tick, for the look at crossings, too") {
  const plan::Plan plan = plan_text("events: locate\nsolver: rk4\n" + oscillator);
  CHECK(plan.crossing_outputs.empty());
  CHECK(plan.crossing_starts.empty());
  const auto count = [](const std::vector<plan::KernelCall>& table) {
    std::size_t blocks = 0;
    for (const plan::KernelCall& call : table) blocks += call.count;
    return blocks;
  };
  CHECK(count(plan.ahead) > 0);
  CHECK(count(plan.ahead) + count(plan.rest) == count(plan.outputs));
}

TEST_CASE("a value that is set between two ticks holds at the next one, also for what was computed ahead") {
  const plan::Plan plan = plan_text("events: locate\nsolver: rk4\n" + oscillator);
  Executor run(plan);
  const std::size_t k = plan.slot({2, 0, -1}).offset, x = plan.layout.states;
  for (int tick = 0; tick < 10; ++tick) {
    run.evaluate();
    run.advance();
  }
  REQUIRE(run.set("k.gain", "10") == Executor::Setting::done);
  run.evaluate();
  CHECK((run.values()[k] == 10.0 * run.values()[x] || run.values()[k] == 10.0 * run.values()[x + 1]));
}

}  // namespace stepwire::run
