#include "engine/model/diagram/flatten.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::diagram {

namespace {

const std::string head = "stepwire: 1\nstep: 1 s\nstop: 3 s\nsolver: rk4\n";
const std::string part =
    "stepwire: 1\nparameters: {mass: 2 kg}\ninputs: {f: {unit: N}}\noutputs: {x: body.position, g: twice}\n"
    "blocks:\n  twice: {block: Gain, u: f, gain: = 2}\n  body: {block: Mass, force: twice, mass: $mass}\n";

std::string flattened(const plan::Plan& plan) {
  return flattened_text(plan.diagram);
}

plan::Plan again(const plan::Plan& plan) {
  Loader loader(library());
  return plan::make_plan(loader.load_text(flattened(plan), "flattened.yaml"));
}

std::string hash_of(const std::string& yaml) {
  return diagram_hash(plan_text(yaml).diagram);
}

}  // namespace

TEST_CASE("a flattened diagram has its parts opened, SI numbers, and recorded names as they were") {
  const DiagramFolder folder;
  folder.write("part.yaml", part);
  folder.write("main.yaml",
               "title: A rig\n" + head +
                   "caption: to be left out\nparameters: {push: 5 mN, T: 3 s}\nsweep: {push: [1 N, 2 N]}\n"
                   "stop_when: rig.x > 5 mm && time >= 2 s\n"
                   "blocks:\n  push: {block: Constant, value: $push, every: $T}\n"
                   "  rig: {diagram: part.yaml, f: push, mass: 500 g}\n"
                   "record: [rig.x, rig.f, {every: 3 s, signals: [push.y, rig.body.velocity]}]\n"
                   "claims: [{that: it moves, final: rig.x, at_least: 0 m}]\n");
  CHECK(flattened(folder.plan("main.yaml")) ==
        R"(stepwire: 1
title: A rig
step: 1 s
stop: 3 s
solver: rk4
stop_when: rig.body.position > 5 mm && time >= 2 s
units: {push: N}
blocks:
  push: {block: Constant, every: 3 s, value: 0.005 N}
  rig.twice: {block: Gain, u: push, gain: 2}
  rig.body: {block: Mass, force: rig.twice, mass: 0.5 kg}
record:
  - {signals: [{rig.x: rig.body.position}, {rig.f: push}]}
  - {every: 3 s, signals: [{push.y: push}, rig.body.velocity]}
)");
}

TEST_CASE("the elementary functions of the diagram stay, and its hash depends on them") {
  const std::string wave = "blocks: {wave: {block: Sine}}\n", libm = "functions: libm\n" + wave;
  CHECK_THAT(flattened(plan_text(libm)), Catch::Contains("functions: libm\n"));
  CHECK(again(plan_text(libm)).diagram.uses_libm);
  CHECK_THAT(flattened(plan_text(wave)), !Catch::Contains("functions"));
  CHECK(hash_of(wave) == hash_of("functions: portable\n" + wave));
  CHECK(hash_of(wave) != hash_of(libm));
  CHECK_THAT(error_of("functions: fast\n" + wave),
             Catch::Contains("functions") && Catch::Contains("portable") && Catch::Contains("libm"));
}

TEST_CASE("the period of a part is written for blocks on which it acts") {
  const DiagramFolder folder;
  folder.write("part.yaml",
               "stepwire: 1\ntitle: p\ninputs: {u: {default: 1}}\noutputs: {y: g, z: h}\n"
               "blocks: {c: {block: Constant, value: 2}, g: {block: Gain, u: c}, h: {block: Gain, u: u}}\n");
  folder.write("main.yaml",
               "title: m\nstepwire: 1\nstep: 1 s\nstop: 9 s\nblocks:\n"
               "  t: {block: Clock}\n  p: {diagram: part.yaml, u: t, every: 3 s}\n"
               "  noisy: {block: Sensor, u: p.y, noise: 1, seed: 9}\nrecord: noisy\n");
  const plan::Plan plan = folder.plan("main.yaml");
  CHECK_THAT(flattened(plan), Catch::Contains("p.c: {block: Constant, value: 2}"));
  CHECK_THAT(flattened(plan), Catch::Contains("p.g: {block: Gain, u: p.c}"));
  CHECK_THAT(flattened(plan), Catch::Contains("p.h: {block: Gain, every: 3 s, u: t}"));
  const plan::Plan flat = again(plan);  // a sensor of a constant measures at every step
  for (const plan::Plan* made : {&plan, &flat})
    for (std::size_t b = 0; b < made->blocks.size(); ++b)
      if (made->diagram.blocks[b].name == "noisy") CHECK(made->blocks[b].rate.ticks == 1);
}

TEST_CASE("inputs and outputs of the diagram itself stay") {
  const plan::Plan plan = plan_text(
      "inputs: {f: {unit: N, default: 3 mN, doc: of the hand}, g: {default: [1, 2]}, angle: {default: 180 "
      "deg}}\noutputs: {half: {signal: half, safe: 0.5 mN, doc: d}, plain: half.y}\n"
      "blocks: {half: {block: Gain, gain: 0.5, u: f}, two: {block: Gain, u: g}, t: {block: Gain, u: "
      "angle}}\n");
  CHECK_THAT(flattened(plan), Catch::Contains(R"(inputs:
  f: {unit: N, default: 0.003, doc: of the hand}
  g: {default: [1, 2]}
  angle: {unit: rad, default: 3.141592653589793}
outputs: {half: {signal: half, safe: 0.0005 N, doc: d}, plain: {signal: half}}
blocks: {half: {block: Gain, u: f, gain: 0.5}, two: {block: Gain, u: g}, t: {block: Gain, u: angle}})"));
  const plan::Plan flat = again(plan);
  REQUIRE(flat.diagram.inputs.size() == 3);
  CHECK(flat.diagram.outputs[0].safe->isApproxToConstant(0.0005));
  CHECK(diagram_hash(flat.diagram) == diagram_hash(plan.diagram));
}

TEST_CASE("values of every kind come back with the same bits") {
  const plan::Plan plan = plan_text(R"(solver: rk4
blocks:
  inf: {block: Constant, value: 0.1}
  tiny: {block: Constant, value: [-0, 5e-324, 1.7976931348623157e308, 0.30000000000000004]}
  deg: {block: Gain, u: "inf", gain: {value: [30], unit: deg}}
  wide: {block: Gain, u: tiny, gain: 3 N/mm}
  turn: {block: MatrixGain, u: [3 mm, 4 mm], gain: {value: [[-0, 1], [2, 0.1]], unit: mm/N}}
  sum: {block: Sum, u: [[1, 2], {value: [3, 4], unit: 1}, 5]}
  lag: {block: Integrator, u: [1, 2], initial: [-0, 0.7 m]}
  limit: {block: Saturation, u: lag, lower: -1}
record: [all, lag.x]
)");
  const std::string text = flattened(plan);
  INFO(text);
  const plan::Plan flat = again(plan);
  CHECK(flattened(flat) == text);
  run::Executor one(plan), other(flat);
  one.evaluate();
  other.evaluate();
  const auto bits = [](const run::Executor& s) {
    const auto& values = s.workspace().values;
    return std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
  };
  CHECK(bits(one) == bits(other));
  CHECK_THAT(text, Catch::Contains("u: \"inf\""));
  CHECK_THAT(text, Catch::Contains("gain: 3000 N/m"));
  CHECK_THAT(text, Catch::Contains("limit: {block: Saturation, u: lag, lower: -1}"));
}

TEST_CASE("a word with a $ in it stays what it is") {
  const DiagramFolder folder;
  folder.write("$x.csv", "time [s],a$b [m]\n0,1\n3,2\n");
  folder.write("main.yaml",
               head + "blocks: {a: {block: FromFile, file: $$x.csv, column: a$$b}}\nrecord: a\n");
  const plan::Plan plan = folder.plan("main.yaml");
  CHECK_THAT(flattened(plan), Catch::Contains("$$x.csv\n") && Catch::Contains("column: [a$$b]"));
  CHECK(flattened(again(plan)) == flattened(plan));
  CHECK(run::run_plan(again(plan)).recordings.at(0).table.columns.at(1).values.back() == 2.0);
}

TEST_CASE("a recorded name may be that of a block inside that it does not mean") {
  const DiagramFolder folder;
  folder.write("part.yaml",
               "stepwire: 1\noutputs: {v: slow}\nblocks:\n  v: {block: Constant, value: 1}\n"
               "  slow: {block: Gain, u: v, gain: 5}\n");
  folder.write("main.yaml", head + "blocks: {p: {diagram: part.yaml}}\nrecord: [p.v, p.slow, p]\n");
  const plan::Plan plan = folder.plan("main.yaml");
  const plan::Plan flat = again(plan);
  const table::Table table = run::run_plan(flat).recordings.at(0).table;
  CHECK(column(table, "p.v").front() == 5.0);
  CHECK(column(table, "p.slow").front() == 5.0);
  CHECK(column(table, "p").front() == 5.0);
}

TEST_CASE("the hash is the same for parts opened by hand, another layout and other units") {
  const DiagramFolder folder;
  folder.write("part.yaml", part);
  folder.write("main.yaml", head + "blocks: {rig: {diagram: part.yaml, f: 3 N}}\nrecord: rig.x\n");
  folder.write("hand.yaml", head + R"(# a comment
blocks:
  rig.twice:
    block: Gain
    gain: 2
    u: 3000 mN
  rig.body: {block: Mass, mass: 2, force: rig.twice}
record: {signals: {rig.x: rig.body.position}}
)");
  const std::string hash = diagram_hash(folder.plan("main.yaml").diagram);
  CHECK(hash.size() == 32);
  CHECK(diagram_hash(folder.plan("hand.yaml").diagram) == hash);
  CHECK(diagram_hash(folder.plan("main.yaml", {{"rig.mass", "2.1 kg"}}).diagram) != hash);
  CHECK(diagram_hash(folder.plan("main.yaml", {{"stop", "4 s"}}).diagram) != hash);
}

TEST_CASE("the hash tells what decides on numbers: wires, conditions and what a record means") {
  const std::string blocks = "blocks: {a: {block: Clock}, b: {block: Gain, u: a}, c: {block: Gain, u: a}}\n";
  const std::string hash = hash_of(blocks + "record: {signals: {x: b}}\nstop_when: b > 2\n");
  CHECK(hash_of(blocks + "record: {signals: {x: b.y}}\nstop_when: b.y > 2\ntitle: T\n") == hash);
  CHECK(hash_of(blocks + "record: {signals: {x: c}}\nstop_when: b > 2\n") != hash);
  CHECK(hash_of(blocks + "record: {signals: {y: b}}\nstop_when: b > 2\n") != hash);
  CHECK(hash_of(blocks + "record: {signals: {x: b}}\nstop_when: c > 2\n") != hash);
}

TEST_CASE("a data file counts by its content, whatever it is called") {
  const DiagramFolder folder;
  const auto hash = [&](const std::string& name, const std::string& rows) {
    folder.write(name, "time [s],x [m]\n0,1\n" + rows + "\n");
    folder.write("main.yaml",
                 head + "blocks: {a: {block: FromFile, file: " + name + ", column: x}}\nrecord: a\n");
    return diagram_hash(folder.plan("main.yaml").diagram);
  };
  const std::string first = hash("one.csv", "3,2");
  CHECK(hash("other.csv", "3,2") == first);
  CHECK(hash("one.csv", "3,2.5") != first);
}

TEST_CASE("data files are named as the caller wishes, from the root where it wishes nothing") {
  const DiagramFolder folder;
  folder.write("x.csv", "time [s],x [m]\n0,1\n3,2\n");
  folder.write("main.yaml", head + "blocks: {a: {block: FromFile, file: x.csv, column: x}}\nrecord: a\n");
  const plan::Plan plan = folder.plan("main.yaml");
  CHECK_THAT(flattened(plan), Catch::Contains("file: " + folder.path("x.csv") + "\n"));
  const std::string text = flattened_text(plan.diagram, [](const std::string&) { return "there/x.csv"; });
  CHECK_THAT(text, Catch::Contains("file: there/x.csv\n"));
}

TEST_CASE("ten thousand blocks are flattened, each with what feeds it") {
  std::string yaml = "solver: rk4\nblocks:\n  b0: {block: Sine, amplitude: 0.1 N}\n";
  for (int i = 1; i <= 10'000; ++i)
    yaml += fmt::format("  b{}: {{block: Lag, u: b{}, tau: {} ms, gain: 1.1}}\n", i, i - 1, i);
  const std::string text = flattened(plan_text(yaml + "record: [b1, b10000]\n"));
  CHECK_THAT(text, Catch::Contains("b10000: {block: Lag") && Catch::Contains("u: b9999"));
  CHECK(text.size() > 500'000);
}

}  // namespace stepwire::diagram
