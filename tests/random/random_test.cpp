#include <catch2/catch.hpp>
#include <filesystem>

#include "blocks/register.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/random/generator.hpp"
#include "tests/random/law_tools.hpp"
#include "tests/random/options.hpp"
#include "tests/random/reshaping.hpp"
#include "tests/random/shrink.hpp"
#include "tests/random/smooth.hpp"

using namespace stepwire;
using random::Sketch;

namespace {

const Registry& all_blocks() {
  static const Registry registry = blocks();
  return registry;
}

std::string whole_text(const Sketch& sketch) {
  std::string text = random::text_of(sketch);
  for (const auto& [file, part] : sketch.parts) text += file + whole_text(part);
  return text;
}

run::RunResult run_with(double number) {
  run::RunResult result;
  result.recordings.emplace_back();
  result.recordings.front().table.columns = {{"time", "s", {0.0, 1.0}}, {"a", "", {0.5, number}}};
  return result;
}

/// Runs of exp(-t) with steps of 1/8, 1/16, ..., each with an error of h^p.
std::vector<run::RunResult> runs_of_order(double order) {
  std::vector<run::RunResult> runs;
  for (int steps = 8; steps <= 512; steps *= 2) {
    run::RunResult run;
    run.recordings.emplace_back();
    std::vector<double> time, values;
    for (int k = 0; k <= steps; ++k) {
      time.push_back(static_cast<double>(k) / steps);
      values.push_back(std::exp(-time.back()) + 0.1 * time.back() * std::pow(1.0 / steps, order));
    }
    run.recordings.front().table.columns = {{"time", "s", time}, {"a", "", values}};
    runs.push_back(std::move(run));
  }
  return runs;
}

random::Options options_of(std::vector<const char*> words) {
  return random::read_options(static_cast<int>(words.size()), words.data());
}

/// Breaks wherever a diagram has a Saturation.
random::Verdict no_saturation(const random::Trial& trial, random::BatchCode&) {
  const bool breaks = random::text_of(trial.sketch).find("Saturation") != std::string::npos;
  return {breaks ? random::Verdict::Kind::different : random::Verdict::Kind::same, ""};
}

Sketch saturated() {
  Sketch sketch;
  sketch.head = {{"step", "0.001 s"}, {"stop", "0.016 s"}, {"events", "locate"}, {"record", "all"}};
  sketch.parameters = {{"p1", "2"}};
  sketch.blocks = {{"n1", {{"block", "Sine"}, {"frequency", "20 Hz"}}},
                   {"n2", {{"block", "Gain"}, {"u", "n1"}, {"gain", "$p1"}}},
                   {"n3", {{"block", "Saturation"}, {"u", "n2"}, {"upper", "0.5"}}},
                   {"n4", {{"block", "Sum"}, {"u", "[n1, n3]"}}}};
  return sketch;
}

}  // namespace

TEST_CASE("a seed gives one diagram, and another seed another one") {
  for (std::uint64_t seed = 1; seed < 30; ++seed) {
    const std::string text = whole_text(random::random_sketch(all_blocks(), seed));
    CHECK(text == whole_text(random::random_sketch(all_blocks(), seed)));
    CHECK(text != whole_text(random::random_sketch(all_blocks(), seed + 1)));
  }
}

TEST_CASE(
    "each type of block that writes no file comes up as the first of "
    "some seed") {
  std::string text;
  for (std::uint64_t seed = 1; seed < 7 * all_blocks().types().size() / 6; ++seed)
    text += whole_text(random::random_sketch(all_blocks(), seed));
  for (const BlockType* type : all_blocks().types()) {
    INFO(type->name);
    CHECK((type->file_output || text.find("block: " + type->name) != std::string::npos));
  }
}

TEST_CASE("a number of another bit is found with its column and row") {
  const double near = std::nextafter(0.25, 1.0);
  CHECK(random::difference(run_with(0.25), run_with(0.25)).empty());
  CHECK(random::difference(run_with(0.25), run_with(near)) == "a, row 1: 0.25000000000000006 and not 0.25");
  CHECK(random::difference(run_with(0.0), run_with(-0.0)) == "a, row 1: -0 and not 0");
}

TEST_CASE("a run that ends in a fault differs from one that does not") {
  run::RunResult ended = run_with(0.25);
  ended.faults.emplace_back();
  CHECK(random::difference(run_with(0.25), ended) == "it runs into a fault and not to its end");
}

TEST_CASE("blocks that move into a part are read through its ports") {
  std::set<std::string> moved{"n2", "n3"};
  const Sketch made = random::with_part(saturated(), moved, "rig", "rig.yaml");
  CHECK(*made.blocks.at(1).find("u") == "[n1, rig.o1_rig]");
  CHECK(*made.blocks.at(2).find("i1_rig") == "n1");
  CHECK(*made.blocks.at(2).find("p1") == "$p1");
  CHECK(*made.parts.at("rig.yaml").blocks.at(0).find("u") == "i1_rig");
  CHECK(made.parts.at("rig.yaml").outputs.at(0).value == "n3");
}

TEST_CASE("a bus and what reads it as a whole stay out of a part") {
  Sketch sketch = saturated();
  sketch.blocks.push_back({"n5", {{"fields", "{a: n1, b: n2}"}}});
  sketch.blocks.push_back({"n6", {{"block", "UnitDelay"}, {"u", "n5"}}});
  std::set<std::string> moved{"n2", "n5", "n6"};
  static_cast<void>(random::with_part(sketch, moved, "rig", "rig.yaml"));
  CHECK(moved == std::set<std::string>{"n2"});
}

TEST_CASE(
    "a diagram that breaks a law is made as small as it can be while it "
    "breaks it") {
  const Scratch folder;
  random::Trials trials(all_blocks(), folder.path(""));
  const random::Law law{"no saturation", no_saturation};
  const Sketch least = random::shrunk(trials, {1, &law, saturated(), ""}).sketch;
  REQUIRE(least.blocks.size() == 1);
  CHECK(*least.blocks.front().find("block") == "Saturation");
  CHECK(*least.blocks.front().find("u") == "0.5");
  CHECK(least.parameters.empty());
  CHECK(random::find_head(least, "events") == nullptr);
}

TEST_CASE("a trial that compares next to nothing counts as one that fails") {
  random::Totals totals;
  totals.valid = 100;
  totals.laws.resize(random::laws().size());
  for (random::LawCount& law : totals.laws) law.meant = 100, law.same = 50;

  CHECK(random::weakness_of(totals, all_blocks()).empty());
  totals.laws.back().same = 1;
  CHECK(random::weakness_of(totals, all_blocks()).find("less than 5 %") != std::string::npos);
  totals.refused["a reason"] = 70;
  CHECK(random::weakness_of(totals, all_blocks()).find("60 %") != std::string::npos);
}

TEST_CASE("an error that falls more slowly than the solver's order breaks the law of halved steps") {
  using Kind = random::Verdict::Kind;
  CHECK(random::verdict_on_order(runs_of_order(2.0), 2, 1e-12).kind == Kind::same);
  CHECK(random::verdict_on_order(runs_of_order(3.0), 2, 1e-12).kind == Kind::same);
  const random::Verdict slow = random::verdict_on_order(runs_of_order(1.0), 2, 1e-12);
  CHECK(slow.kind == Kind::different);
  CHECK(slow.text == "a: the error falls by 2^1.00 with half of the step, and not by 2^2");
  CHECK(random::verdict_on_order(runs_of_order(4.0), 4, 1e-3).kind == Kind::skipped);
}

TEST_CASE("one seed in seven gives a smooth diagram") {
  for (std::uint64_t seed = 3; seed < 700; seed += 7) {
    const Sketch sketch = random::random_sketch(all_blocks(), seed);
    INFO(whole_text(sketch));
    CHECK(random::why_not_smooth(sketch) == "");
  }
}

TEST_CASE("a diagram that bends between ticks is not smooth") {
  CHECK(random::why_not_smooth(saturated()) == "Saturation may bend");
  Sketch sketch = saturated();
  sketch.blocks[2] = {"n3", {{"block", "UnitDelay"}, {"u", "n2"}}};
  CHECK(random::why_not_smooth(sketch) == "UnitDelay keeps to each step");
  sketch.blocks[2].keys.push_back({"every", "0.002 s"});
  CHECK(random::why_not_smooth(sketch) == "");
  sketch.blocks[2] = {"n3", {{"block", "Step"}, {"time", "0.0025 s"}}};
  CHECK(random::why_not_smooth(sketch) == "");  // its events are located
  std::erase_if(sketch.head, [](const random::Key& key) { return key.name == "events"; });
  CHECK(random::why_not_smooth(sketch) == "Step jumps between ticks");
}

TEST_CASE("a wrong command line is refused, and help is one") {
  CHECK(options_of({"--help"}).help);
  CHECK(options_of({"--count", "7", "--with-code", "2", "--forever"}).with_code == 2);
  CHECK_THROWS_WITH(options_of({"--cuont", "7"}), "unknown option '--cuont'; see --help");
  CHECK_THROWS_WITH(options_of({"--count"}), "give a value behind --count");
  CHECK_THROWS_WITH(options_of({"--count", "7x"}), "'7x' is no whole number");
}
