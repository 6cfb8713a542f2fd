// Wires that name an element of a signal.
#include <catch2/catch.hpp>

#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::plan {

namespace {

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("a wire takes an element of a vector, without a block") {
  const plan::Plan plan = plan_text(
      "blocks: {v: {block: Constant, value: [1, 2, 3]}, a: {block: Gain, u: v.2, gain: 10},"
      " b: {block: Sum, u: [v.3, a, v.1]}}\nrecord: [a, b]\n");
  CHECK(plan.blocks.size() == 3);
  CHECK(plan.blocks[1].inputs[0][0].offset == plan.blocks[0].outputs[0].offset + 1);
  CHECK(plan.blocks[1].inputs[0][0].size == 1);
  run::Executor simulation(plan);
  simulation.evaluate();
  CHECK(simulation.values()[plan.blocks[2].outputs[0].offset] == 24.0);
}

TEST_CASE("an element passes through ports of parts, and ports have elements") {
  DiagramFolder folder;
  folder.write("part.yaml",
               "stepwire: 1\ninputs: {u: {}, w: {}}\noutputs: {y: g, z: s}\n"
               "blocks: {g: {block: Gain, u: u, gain: 2}, s: {block: Sum, u: [u.2, w]}}\n");
  folder.write("user.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 1 s\nblocks: {v: {block: Constant, value: [1, 2, 3]},"
               " p: {diagram: part.yaml, u: v, w: v.3}, q: {block: Gain, u: p.y.3, gain: 1}}\n"
               "record: [p.z, q, p.y.1, {signals: {mine: v.2}}]\n");
  const table::Table run = folder.run("user.yaml");
  CHECK(column(run, "p.z").back() == 5.0);
  CHECK(column(run, "q").back() == 6.0);
  CHECK(column(run, "p.y.1").back() == 2.0);
  CHECK(column(run, "mine").back() == 2.0);
}

TEST_CASE("an element that a signal has not is refused with how many there are") {
  CHECK(faults_of(
            "blocks: {v: {block: Constant, value: [1, 2, 3]}, a: {block: Gain, u: v.4}}\nrecord: [a]\n") ==
        Lines{"test.yaml:1:70: a.u: there is no 'v.4'; the signal has 3 elements"});
}

TEST_CASE("an element of a matrix has a row and a column") {
  CHECK(faults_of("blocks: {R: {block: Constant, value: [[1, 2], [3, 4]]}, a: {block: Gain, u: "
                  "R.2}}\nrecord: [a]\n") == Lines{"test.yaml:1:77: a.u: there is no 'R.2'; the signal is a "
                                                   "2 x 2 matrix, of which an element has a row "
                                                   "and a column, as in '.2.1'"});
}

TEST_CASE("an element that is recorded beside its signal is the same column") {
  const table::Table run =
      result_of("blocks: {v: {block: Constant, value: [1, 2]}}\nrecord: [v, v.2]\n").recordings[0].table;
  CHECK(run.columns.size() == 3);
}

TEST_CASE("a flattened diagram keeps elements") {
  const std::string text =
      "blocks: {v: {block: Constant, value: [1, 2, 3]}, a: {block: Gain, u: v.2, gain: 10}}\nrecord: [a]\n"
      "stop_when: v.3 > 5\n";
  const plan::Plan plan = plan_text(text);
  CHECK(plan.diagram.blocks[1].inputs[0][0].element == diagram::ElementIndex{2, 0});
  CHECK(plan.offset(plan.diagram.stop_when->variables[0]) == plan.blocks[0].outputs[0].offset + 2);
}

}  // namespace stepwire::plan
