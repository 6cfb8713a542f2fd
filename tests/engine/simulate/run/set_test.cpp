#include <bit>
#include <catch2/catch.hpp>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::run {
using Catch::Contains;

namespace {

const std::string spring = R"(step: 1 ms
stop: 0.2 s
solver: rk4
parameters:
  mass: {value: 2 kg, above: 0}
  stiffness: 300 N/m
  rate: {value: =sqrt(stiffness/mass), at_least: 1}
  curve: {value: [0, 1, 4], unit: N}
  push: 1 N
inputs: {hand: {default: 0 N}}
blocks:
  sine: {block: Sine, frequency: 5 Hz}
  wind: {block: Noise, seed: 3, every: 10 ms}
  sum: {block: Sum, signs: "+++-", u: [$push, gust, hand, force]}
  gust: {block: Gain, gain: 2 N, u: wind}
  accelerate: {block: Gain, gain: =1/mass, u: sum}
  speed: {block: Integrator, u: accelerate}
  place: {block: Integrator, u: speed, initial: 1 mm}
  force: {block: Gain, gain: $stiffness, u: place}
  table: {block: LookupTable, u: sine, points: [-1, 0, 1], values: $curve}
  filter: {block: Lag, tau: =0.5*rate^-1, u: table}
  late: {block: Delay, delay: 5 ms, u: table}
record: all
)";

plan::Plan plan_with(const std::string& yaml, const std::vector<diagram::Setting>& settings = {}) {
  return plan_text(yaml, settings);
}

void go(Executor& run, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    run.evaluate();
    run.advance();
  }
}

/// The bits of all signals and states of some ticks. Derivatives are the solver's own affair.
std::vector<std::uint64_t> next(Executor& run, int ticks) {
  const plan::Layout& layout = run.plan().layout;
  std::vector<std::uint64_t> all;
  const auto add = [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) all.push_back(std::bit_cast<std::uint64_t>(run.values()[i]));
  };
  for (int i = 0; i < ticks; ++i) {
    run.evaluate();
    add(layout.signals, layout.derivatives);
    add(layout.discrete, layout.discrete + layout.discrete_count);
    run.advance();
  }
  return all;
}

std::string refusal(Executor& run, const std::string& name, const std::string& value) {
  try {
    static_cast<void>(run.set(name, value));
  } catch (const yaml::Error& error) {
    return error.what();
  }
  return "";
}

struct Case {
  std::string name, value;
};

const std::vector<Case> cases = {{"mass", "5 kg"},
                                 {"stiffness", "120 N/m"},
                                 {"rate", "40"},
                                 {"curve", "{value: [1, 3, 5], unit: N}"},
                                 {"push", "-2 N"},
                                 {"sum.u.1", "7 N"},
                                 {"force.gain", "80 N/m"},
                                 {"sine.amplitude", "0.2"},
                                 {"filter.tau", "2 ms"},
                                 {"wind.seed", "9"},
                                 {"place.initial", "3 mm"},
                                 {"table.points", "[-2, 0, 2]"}};

}  // namespace

TEST_CASE("a value set between two ticks gives the bits of a run that begins with it and with that state") {
  const plan::Plan plan = plan_with(spring);
  for (const Case& one : cases) {
    INFO(one.name << "=" << one.value);
    Executor run(plan);
    go(run, 37);
    const Workspace kept = run.workspace();
    REQUIRE(run.set(one.name, one.value) == Executor::Setting::done);
    if (one.name == "sum.u.1") continue;  // no file sets what is wired
    const plan::Plan own = plan_with(spring, {{one.name, one.value}});
    Executor begun(own);
    begun.restore(kept);
    CHECK((next(run, 60) == next(begun, 60)));
    run.reset();
    begun.reset();
    CHECK((next(run, 60) == next(begun, 60)));
  }
}

TEST_CASE("what a wire carries can be set as well") {
  const plan::Plan plan = plan_text("blocks: {a: {block: Gain, gain: 3, u: 2}}\nrecord: a\n");
  Executor one(plan);
  REQUIRE(one.set("a.u", "5") == Executor::Setting::done);
  one.evaluate();
  CHECK(one.values()[one.plan().blocks[0].outputs[0].offset] == 15.0);
}

TEST_CASE("compiled code takes values as the interpreter does, and is left for those that it does not read") {
  codegen::GeneratedCode source{run::code_trial()};
  const plan::Plan plan = plan_with(spring);
  std::vector<std::string> names;
  for (const Case& one : cases)
    if (one.name != "sum.u.1") names.push_back(one.name);
  const auto code =
      source.compile(plan, plan::variable_blocks(plan, diagram::Variation(plan.diagram, names)), {});
  const auto fixed = source.compile(plan, {}, {});
  if (!code || !fixed) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  for (const Case& one : cases) {
    INFO(one.name << "=" << one.value);
    Executor interpreted(plan), compiled(plan), left(plan);
    compiled.use(*code);
    left.use(*fixed);
    for (Executor* run : {&interpreted, &compiled, &left}) {
      go(*run, 37);
      REQUIRE(run->set(one.name, one.value) == Executor::Setting::done);
    }
    CHECK(compiled.compiled());
    const auto expected = next(interpreted, 60);
    CHECK((next(compiled, 60) == expected));
    CHECK((next(left, 60) == expected));
  }
  Executor left(plan);
  left.use(*fixed);
  REQUIRE(left.set("mass", "3 kg") == Executor::Setting::done);
  CHECK_FALSE(left.compiled());
  left.use(*fixed);
  CHECK_FALSE(left.compiled());
}

TEST_CASE("code is left once a number changes that stands in it, and code that is widened for it serves") {
  codegen::GeneratedCode source{run::code_trial()};
  const plan::Plan plan = plan_text(
      "step: 1 ms\nparameters: {x: [0, 1, 2], y: [0, 3, 5]}\nblocks:\n  wave: {block: Sine, amplitude: 2}\n"
      "  table: {block: LookupTable, u: wave, points: $x, values: $y}\nrecord: table\n");
  const diagram::Variation lists(plan.diagram, {"x", "y"});
  std::vector<plan::VariableBlock> variable = plan::variable_blocks(plan, lists);
  const auto set_lists = [&](Executor& run, const std::string& x, const std::string& y) {
    const std::vector<diagram::Assignment> both{{"x", diagram::value_of_text(x, ""), ""},
                                                {"y", diagram::value_of_text(y, ""), ""}};
    REQUIRE(run.set(lists, both) == Executor::Setting::done);
  };
  const auto code = source.compile(plan, variable, {});
  Executor longer(plan);
  set_lists(longer, "[0, 0.5, 1, 2]", "[0, 4, 3, 5]");
  longer.widen(variable);
  const auto wide = source.compile(plan, variable, {});
  if (!code || !wide) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  Executor first(plan), second(plan);
  first.use(*code);
  second.use(*wide);
  for (Executor* run : {&first, &second}) set_lists(*run, "[0, 1.5, 2]", "[0, 4, 3]");
  CHECK((first.compiled() && second.compiled()));
  for (Executor* run : {&first, &second}) set_lists(*run, "[0, 0.5, 1, 2]", "[0, 4, 3, 5]");
  CHECK_FALSE(first.compiled());
  CHECK(second.compiled());
  const auto expected = next(longer, 60);
  CHECK((next(first, 60) == expected));
  CHECK((next(second, 60) == expected));
}

TEST_CASE("a refused value leaves everything as it was, and says what would be right") {
  const plan::Plan plan = plan_with(spring);
  Executor run(plan), untouched(plan);
  go(run, 10);
  go(untouched, 10);
  CHECK_THAT(refusal(run, "mass", "-1 kg"), Contains("mass") && Contains("above 0"));
  CHECK_THAT(refusal(run, "mass", "2 N"), Contains("mass") && Contains("kg"));
  CHECK_THAT(refusal(run, "stiffness", "1 N/m"), Contains("rate") && Contains("at least 1"));
  CHECK_THAT(refusal(run, "filter.tau", "-1 ms"), Contains("filter.tau"));
  CHECK_THAT(refusal(run, "table.points", "[3, 2, 1]"), Contains("table.points"));
  CHECK_THAT(refusal(run, "masss", "1 kg"), Contains("mass"));
  CHECK_THAT(refusal(run, "mass", "[1"), Contains("mass"));
  CHECK((next(run, 60) == next(untouched, 60)));
  Executor again(plan);
  REQUIRE(again.set("stiffness", "150 N/m") == Executor::Setting::done);  // nothing of them is left
  CHECK_THAT(refusal(again, "mass", "1000 kg"), Contains("rate"));
}

TEST_CASE("values that need another plan are answered so, and change nothing") {
  const plan::Plan plan = plan_with(spring);
  for (const Case& one : std::vector<Case>{{"step", "2 ms"}, {"late.delay", "6 ms"}, {"curve", "[1, 2]"}}) {
    INFO(one.name);
    Executor run(plan), untouched(plan);
    go(run, 10);
    go(untouched, 10);
    if (one.name == "curve") {
      CHECK_THAT(refusal(run, one.name, one.value), Contains("table"));
    } else {
      CHECK(run.set(one.name, one.value) == Executor::Setting::structure_changed);
      CHECK_THAT(run.structure_change(), Contains(one.name.substr(0, 4)));
    }
    CHECK((next(run, 60) == next(untouched, 60)));
  }
}

TEST_CASE("a parameter of a part reaches the part's blocks") {
  const DiagramFolder folder;
  folder.write("part.yaml",
               "stepwire: 1\nparameters: {k: 1}\ninputs: {u: {}}\noutputs: {y: double.y}\n"
               "blocks: {double: {block: Gain, gain: =2*k, u: u}}\n");
  folder.write("main.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 3 s\nparameters: {a: 3}\nblocks:\n  c: {block: Clock}\n"
               "  rig: {diagram: part.yaml, k: =a+1, u: c}\nrecord: rig.y\n");
  const plan::Plan plan = folder.plan("main.yaml");
  const auto last = [](Executor& run) {
    run.reset();
    go(run, 2);
    run.evaluate();
    return run.values()[run.plan().slot(run.plan().diagram.records[0].signals[0].signal).offset];
  };
  Executor run(plan);
  CHECK(last(run) == 16.0);
  REQUIRE(run.set("a", "4") == Executor::Setting::done);
  CHECK(last(run) == 20.0);
  REQUIRE(run.set("rig.k", "7") == Executor::Setting::done);
  CHECK(last(run) == 28.0);
  REQUIRE(run.set("a", "1") == Executor::Setting::done);  // rig.k was set by its own name, and stays
  CHECK(last(run) == 28.0);
}

}  // namespace stepwire::run
