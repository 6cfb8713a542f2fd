#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {
using Catch::Contains;

namespace {

record::Recording swept(const std::string& yaml, const std::vector<diagram::Setting>& settings = {}) {
  const DiagramFolder folder;
  folder.write("sweep.yaml", "stepwire: 1\nstep: 1 s\nstop: 1 s\n" + yaml);
  diagram::Loader loader(library());
  const Job job = make_job(loader, folder.path("sweep.yaml"), settings);
  return run_job(job).recordings.at(0);
}

const std::string two =
    "parameters: {a: 2, b: 3 mm, c: = 5*a}\nblocks:\n  y: {block: Constant, value: [$a, $c]}\n"
    "  z: {block: Constant, value: $b}\nrecord: [y, z]\n";

std::vector<std::string> words_of(const record::Recording& recording, const std::string& name) {
  std::vector<std::string> texts;
  for (const record::Categories& words : recording.categories)
    if (words.column == name)
      for (const double number : column(recording.table, name))
        texts.push_back(words.texts.at(static_cast<std::size_t>(number)));
  return texts;
}

}  // namespace

TEST_CASE("one parameter at a time leaves the file's value") {
  const record::Recording all = swept(two + "sweep: {one_at_a_time: {a: [1, 4], b: [1 mm, 5 mm, 9 mm]}}\n");
  CHECK(column(all.table, "a") == std::vector<double>{2, 2, 1, 1, 4, 4, 2, 2, 2, 2, 2, 2});
  const std::vector<double> b{0.003, 0.003, 0.003, 0.003, 0.003, 0.003,
                              0.001, 0.001, 0.005, 0.005, 0.009, 0.009};
  CHECK(column(all.table, "b") == b);
  CHECK(column(all.table, "z") == b);
  CHECK(column(all.table, "y.1") == column(all.table, "a"));
}

TEST_CASE("each point says which parameter differs, and to what") {
  const record::Recording all = swept(two + "sweep: {one_at_a_time: {a: [1, 4], b: [1 mm, 5 mm]}}\n");
  CHECK(words_of(all, "differs") ==
        std::vector<std::string>{"base", "base", "a", "a", "a", "a", "b", "b", "b", "b"});
  CHECK(words_of(all, "differs_to") ==
        std::vector<std::string>{"", "", "1", "1", "4", "4", "1 mm", "1 mm", "5 mm", "5 mm"});
}

TEST_CASE("what follows from a parameter follows it, and has its own range where it is varied itself") {
  const record::Recording all =
      swept(two + "sweep: {one_at_a_time: {a: [1], b: {from: 1 mm, to: 2 mm, count: 2}}}\n");
  CHECK(column(all.table, "y.2") == std::vector<double>{10, 10, 5, 5, 10, 10, 10, 10});
  const record::Recording own = swept(two + "sweep: {one_at_a_time: {c: [1, 20]}}\n");
  CHECK(column(own.table, "y.2") == std::vector<double>{10, 10, 1, 1, 20, 20});
}

TEST_CASE("values of the call are those from which one parameter at a time differs") {
  const std::string yaml = two + "sweep: {one_at_a_time: {b: [1 mm]}}\n";
  CHECK(column(swept(yaml, {{"a", "7"}}).table, "y.1") == std::vector<double>{7, 7, 7, 7});
}

TEST_CASE("a number or an initial value of a block is varied one at a time as --set reaches it") {
  const std::string yaml =
      "parameters: {a: 2}\nsolver: euler\nblocks:\n  c: {block: Constant, value: = 3*a}\n"
      "  i: {block: Integrator, u: c, initial: [7, 8]}\n  g: {block: Gain, u: c, gain: 5 mm}\n"
      "record: [c, g, i]\nsweep: {one_at_a_time: {a: [4], c.value: [1], g.gain: [1 m], i.initial: [[0, "
      "1]]}}\n";
  const record::Recording all = swept(yaml);
  CHECK(column(all.table, "c.1") == std::vector<double>{6, 6, 6, 6, 1, 1, 6, 6, 6, 6});
  CHECK(column(all.table, "g.gain") ==
        std::vector<double>{0.005, 0.005, 0.005, 0.005, 0.005, 0.005, 1, 1, 0.005, 0.005});
  CHECK(column(all.table, "i.2") == std::vector<double>{8, 14, 8, 14, 8, 9, 8, 14, 1, 7});
}

TEST_CASE("a parameter of a part and the file's own times are varied one at a time") {
  const DiagramFolder folder;
  folder.write("part.yaml",
               "stepwire: 1\nparameters: {up: 1, mass: 5 kg}\noutputs: {out: y}\n"
               "blocks:\n  y: {block: Constant, value: = up*mass}\n");
  folder.write("sweep.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 2 s\nblocks:\n  rig: {diagram: part.yaml, up: 2}\n"
               "record: [rig.out]\nsweep: {one_at_a_time: {rig.mass: [3 kg], rig.up: [1], stop: [1 s]}}\n");
  diagram::Loader loader(library());
  const record::Recording all = run_job(make_job(loader, folder.path("sweep.yaml"), {})).recordings.at(0);
  CHECK(column(all.table, "rig.out") == std::vector<double>{10, 10, 10, 6, 6, 6, 5, 5, 5, 10, 10});
  CHECK(column(all.table, "rig.mass") == std::vector<double>{5, 5, 5, 3, 3, 3, 5, 5, 5, 5, 5});
}

TEST_CASE("a number in quotes among swept values is refused as the text that it is") {
  CHECK_THROWS_WITH(swept(two + "sweep: {a: [\"1\", 2]}\n"),
                    Contains("'1' is text because of its quotes; leave them out for a number"));
}

TEST_CASE("a list of swept values has no further keys, such as a unit that would be ignored") {
  for (const std::string axis : {"{values: [2, 3], unit: mm}", "{values: [2 mm, 3 mm], doc: gap}"})
    for (const std::string section : {"b: " + axis, "one_at_a_time: {b: " + axis + "}"}) {
      INFO(section);
      CHECK_THROWS_WITH(swept(two + "sweep: {" + section + "}\n"),
                        Contains("beside 'values'; each value has its unit: [1 mm, 2 mm]"));
    }
}

TEST_CASE("what one parameter at a time cannot be is refused in words") {
  CHECK_THROWS_WITH(swept(two + "sweep: {one_at_a_time: {y.valu: [1]}}\n"),
                    Contains("did you mean 'y.value'"));
  CHECK_THROWS_WITH(swept(two + "sweep: {one_at_a_time: {solver: [euler]}}\n"),
                    Contains("one_at_a_time.solver: has no value in the file"));
  CHECK_THROWS_WITH(swept(two + "sweep: {one_at_a_time: {q: [1]}}\n"),
                    Contains("one_at_a_time.q: is no parameter"));
  CHECK_THROWS_WITH(swept(two + "sweep: {one_at_a_time: {a: [1]}, b: [1 mm]}\n"), Contains("stands alone"));
  CHECK_THROWS_WITH(swept(two + "sweep: {one_at_a_time: [a]}\n"), Contains("is a map of parameters"));
  CHECK_THROWS_WITH(swept(two + "sweep: {one_at_a_time: {a: []}}\n"), Contains("has no values"));
  CHECK_THROWS_WITH(swept(two + "sweep: {one_at_a_time: {b: [1 N]}}\n"), Contains("b"));
}

}  // namespace stepwire::run
