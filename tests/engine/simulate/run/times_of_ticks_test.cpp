#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "engine/base/math/tick_times.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

/// Three ways to wait until a time on a tick, and a source that steps there. Each integral of 1 from there to
/// `stop` is stop - at.
std::string waits(const std::string& step, const std::string& at, const std::string& stop,
                  const std::string& more = "") {
  return fmt::format(R"(step: {}
stop: {}
solver: rk4
{}blocks:
  m: {{block: StateMachine, states: {{a: {{output: 0, timeout: {{b: {}}}}}, b: {{output: 1}}}}}}
  g: {{block: StateMachine, states: {{a: {{output: 0, to: {{b: after >= {}}}}}, b: {{output: 1}}}}}}
  s: {{block: Step, time: {}}}
  by_timeout: {{block: Integrator, u: m.y}}
  by_guard: {{block: Integrator, u: g.y}}
  by_step: {{block: Integrator, u: s}}
  by_time: {{block: Integrator, u: 1, enable: time >= {}}}
record: [by_timeout, by_guard, by_step, by_time]
)",
                     step, stop, more, at, at, at, at);
}

struct Case {
  const char *step, *at, *stop;
  double left;  ///< stop - at [s]
};
const Case cases[] = {{"0.3 s", "0.9 s", "1.8 s", 0.9},
                      {"0.3 ms", "1.5 ms", "3 ms", 1.5e-3},
                      {"0.3 ms", "2.7 ms", "3 ms", 0.3e-3},
                      {"0.7 s", "2.1 s", "2.8 s", 0.7},
                      {"0.1 s", "0.3 s", "1 s", 0.7}};

}  // namespace

TEST_CASE("a time that is a whole multiple of a decimal step is at its tick") {
  for (const Case& of : cases)
    for (const char* more : {"", "events: locate\n"}) {
      INFO(of.step << " " << of.at << " " << more);
      const table::Table run = run_text(waits(of.step, of.at, of.stop, more));
      for (const char* name : {"by_timeout", "by_guard", "by_step", "by_time"}) {
        INFO(name);
        CHECK(column(run, name).back() == Approx(of.left).epsilon(1e-9));
      }
    }
}

TEST_CASE("times of ticks are the numbers that their decimals are") {
  const table::Table run = run_text(waits("0.3 s", "0.9 s", "2.1 s"));
  CHECK(column(run, "time") == std::vector<double>{0.0, 0.3, 0.6, 0.9, 1.2, 1.5, 1.8, 2.1});
  CHECK(tick_times(0.3)(3.0) == 0.9);
  CHECK(tick_times(0.0003)(9.0) == 0.0027);
  CHECK(tick_times(0.7)(3.0) == 2.1);
  CHECK(tick_times(250.0)(3.0) == 750.0);
  CHECK(tick_times(1.0 / 44100.0)(44100.0) == 1.0);
  CHECK(tick_times(1e-9)(3000000007.0) == 3.000000007);
  const double odd = 0.1234567890123456789;  // no short decimal: a multiple of the number itself
  CHECK(tick_times(odd)(1.0) == odd);
  CHECK(tick_times(odd)(3.0) == 3.0 * odd);
}

TEST_CASE("a run ends at the tick at which stop_when is true by its decimal") {
  for (const char* more : {"", "events: locate\n"}) {
    const std::string head = std::string(more) + "stop_when: time >= 0.9 s\n";
    CHECK(column(run_text(waits("0.3 s", "0.9 s", "1.8 s", head)), "time").back() == 0.9);
  }
}

TEST_CASE("compiled code has the times of the interpreter") {
  codegen::GeneratedCode source{run::code_trial()};
  for (const Case& of : cases) {
    const plan::Plan plan = plan_text(waits(of.step, of.at, of.stop));
    const auto code = source.compile(plan, {}, {});
    INFO(source.take_problem());
    REQUIRE(code);
    Executor compiled(plan), interpreted(plan);
    compiled.use(*code);
    for (; !interpreted.finished(); compiled.advance(), interpreted.advance()) {
      compiled.evaluate();
      interpreted.evaluate();
      CHECK(compiled.values()[plan::Layout::time] == interpreted.values()[plan::Layout::time]);
      for (std::size_t i = plan.layout.signals; i < plan.layout.derivatives; ++i)
        CHECK(compiled.values()[i] == interpreted.values()[i]);
    }
  }
}

}  // namespace stepwire::run
