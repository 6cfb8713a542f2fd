// Stored state of parts and blocks that run on condition: flattened files, checkpoints, values.
#include <catch2/catch.hpp>

#include "engine/model/diagram/flatten.hpp"
#include "engine/simulate/run/executor.hpp"
#include "tests/engine/simulate/run/guard_rig.hpp"

using namespace stepwire;

TEST_CASE("a flattened file has the guards, and the same bits") {
  const Rig rig;
  const char* const blocks =
      "  flow: {block: Sine, amplitude: 1, frequency: 1 Hz, bias: 3}\n"
      "  t: {diagram: tank.yaml, flow: flow, enable: {when: on > 0.5, states: reset, outputs: reset}}\n"
      "  c: {diagram: counter.yaml, trigger: on, every: 20 ms}\n"
      "  x: {block: Integrator, u: t.twice, enable: {when: c.count < 2, outputs: 4}}\n";
  rig.folder.write("all.yaml", Rig::text(blocks, "[t.level, t.twice, c.count, x, x.active]", ""));
  const plan::Plan plan = rig.folder.plan("all.yaml");
  const std::string flat = diagram::flattened_text(plan.diagram);
  INFO(flat);
  CHECK(flat.find("guard: t.active") != std::string::npos);
  const table::Table first = rig.folder.run("all.yaml");
  rig.folder.write("flat.yaml", flat);
  const table::Table second = rig.folder.run("flat.yaml");
  REQUIRE(first.columns.size() == second.columns.size());
  for (std::size_t i = 0; i < first.columns.size(); ++i)
    CHECK(first.columns[i].values == second.columns[i].values);
}

TEST_CASE("a run goes on from a kept moment with the edge that its trigger saw") {
  const Rig rig;
  rig.folder.write("all.yaml", Rig::text("  c: {diagram: counter.yaml, trigger: on}\n", "[c.count]", ""));
  const plan::Plan plan = rig.folder.plan("all.yaml");
  run::Executor run(plan);
  run::Workspace kept;
  std::vector<double> all, again;
  const std::size_t count = plan.slot(plan.diagram.records[0].signals[0].signal).offset;
  for (int tick = 0; tick <= 60; ++tick) {
    if (tick == 15) kept = run.workspace();
    run.evaluate();
    if (tick >= 15) all.push_back(run.values()[count]);
    run.advance();
  }
  run.restore(kept);
  for (int tick = 15; tick <= 60; ++tick) {
    run.evaluate();
    again.push_back(run.values()[count]);
    run.advance();
  }
  CHECK(all == again);
  CHECK(all.back() == 2.0);
}

TEST_CASE("an initial value that is set holds for what a guard puts back") {
  const Rig rig;
  rig.folder.write(
      "all.yaml",
      Rig::text("  x: {block: Integrator, u: 0, enable: {when: on, states: reset}}\n", "[x]", ""));
  const plan::Plan plan = rig.folder.plan("all.yaml");
  run::Executor run(plan);
  REQUIRE(run.set("x.initial", "5") == run::Executor::Setting::done);
  for (int tick = 0; tick <= 12; ++tick) {
    run.evaluate();
    run.advance();
  }
  run.evaluate();
  CHECK(run.values()[plan.slot(plan.diagram.records[0].signals[0].signal).offset] == 5.0);
}

TEST_CASE("blocks of a part that is off lie in one row, which is passed over in one go") {
  const Rig rig;
  std::string blocks = "  c: {diagram: many.yaml, u: on, enable: on}\n";
  std::string many =
      "stepwire: 1\ntitle: m\ninputs: {u: {}}\noutputs: {y: g99}\nblocks:\n  g0: {block: Gain, u: u, gain: "
      "1}\n";
  for (int i = 1; i < 100; ++i)
    many += "  g" + std::to_string(i) + ": {block: " + (i % 2 ? "Gain" : "Abs") + ", u: g" +
            std::to_string(i - 1) + "}\n";
  rig.folder.write("many.yaml", many);
  rig.folder.write("all.yaml", Rig::text(blocks, "[c.y]", ""));
  const plan::Plan plan = rig.folder.plan("all.yaml");
  std::size_t changes = 0;
  for (std::size_t i = 1; i < plan.outputs.size(); ++i)
    if (plan.outputs[i].active != plan.outputs[i - 1].active) ++changes;
  CHECK(changes <= 2);
}

TEST_CASE("all that is recorded of a part with outputs that are reset is what others read of it") {
  const Rig rig;
  const std::string blocks =
      "  t: {diagram: tank.yaml, flow: 1, enable: {when: on, outputs: reset}}\n"
      "  x: {block: Integrator, u: 1, enable: {when: on, outputs: 4}}\n";
  const table::Table all = rig.run(blocks, "all");
  const table::Table named = rig.run(blocks, "[t.level, t.twice, x]");
  for (const char* name : {"t.level", "t.twice", "x"}) CHECK(column(all, name) == column(named, name));
  CHECK(column(all, "x").front() == 4.0);
  CHECK(all.find("x.y_shown") == nullptr);
}

TEST_CASE("a block with outputs that are empty has them reset, too") {
  const Rig rig;
  rig.folder.write("all.yaml", Rig::text("  a: {block: Mux, u: [1, 2, 3]}\n"
                                         "  d: {block: Demux, u: a, sizes: [1, 2], enable: {when: on, "
                                         "outputs: reset}}\n",
                                         "[d.y1, d.y2]", ""));
  const plan::Plan plan = rig.folder.plan("all.yaml");
  rig.folder.write("flat.yaml", diagram::flattened_text(plan.diagram));
  const table::Table first = rig.folder.run("all.yaml"), second = rig.folder.run("flat.yaml");
  CHECK(column(first, "d.y2.2") == column(second, "d.y2.2"));
  CHECK(column(first, "d.y2.2").at(20) == 3.0);
  CHECK(column(first, "d.y2.2").front() == 0.0);
}
