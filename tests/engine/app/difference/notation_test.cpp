#include <catch2/catch.hpp>

#include "engine/app/difference/difference_text.hpp"
#include "engine/base/math/random.hpp"
#include "engine/base/yaml/yaml_text.hpp"
#include "tests/engine/app/difference/comparing.hpp"

namespace stepwire::difference {
namespace {

using Lines = std::vector<std::string>;

/// Compares a file with another text of it; parts are those of the file.
Lines lines_of_other(const std::string& file, const std::string& text) {
  Texts before, after;
  after.give(file, text);
  Comparer comparer(every_block(), before, after);
  comparer.compare(file, file);
  return lines(comparer.result());
}

/// Puts the entries of all maps into another order, but for states, transitions and counters, whose order has
/// a meaning.
void shuffle(yaml::Node& node, std::uint64_t& count, bool keeps_order = false) {
  for (yaml::Node& item : node.items) shuffle(item, count);
  for (yaml::Entry& entry : node.entries)
    shuffle(entry.value, count, entry.key == "states" || entry.key == "to" || entry.key == "counters");
  for (std::size_t i = node.entries.size(); i > 1 && !keeps_order; --i)
    std::swap(node.entries[i - 1], node.entries[random_bits(7, count++) % i]);
}

}  // namespace

TEST_CASE("a diagram that is written anew without comments means the same, for every diagram") {
  const std::vector<std::string> files = all_diagrams();
  CHECK(files.size() > 200);
  for (const std::string& file : files) {
    INFO(file);
    CHECK(lines_of_other(file, yaml::yaml_text(yaml::read_document(file).root)) == Lines{});
  }
}

TEST_CASE("a diagram with its blocks and keys in another order means the same, for every diagram") {
  std::uint64_t count = 0;
  for (const std::string& file : all_diagrams()) {
    INFO(file);
    yaml::Document document = yaml::read_document(file);
    shuffle(document.root, count);
    CHECK(lines_of_other(file, yaml::yaml_text(document.root)) == Lines{});
  }
}

TEST_CASE("units, defaults, brackets and short forms are no difference") {
  const auto same = [](const std::string& from, const std::string& to) {
    INFO(from << " and " << to);
    CHECK(lines(loop_yaml, with(loop_yaml, from, to)) == Lines{});
  };
  same("step: 1 ms", "step: 0.001 s");
  same("step: 1 ms", "step: 0.001");
  same("step: 1 ms", "\"step\": 1 ms  # tick");
  same("3 N", "3000 mN");
  same("2 Hz}", "2 Hz, phase: 0 rad, bias: 0}");
  same("weight: 2 kg", "weight: {value: 2000 g}");
  same("weight: 2 kg", "weight: {value: 2, unit: kg}");
  same("400 N/m", "0.4 N/mm");
  same("force: sum", "force: sum.y");
  same("= -stiffness", "= - stiffness");
  same("record: [body.position, spring]", "record: [spring, body.position]");
  same("record: [body.position, spring]", "record:\n  - {signals: body.position}\n  - {signals: [spring]}");
  same("figure: {plot", "figure:\n  - {plot");
  same("[push, spring]}", "[push, spring], signs: \"\"}");
  same("max: abs(body.position)", "max: abs( body.position )");
  same("0.5 m}", "500 mm}");
  same("solver: rk4", "solver: rk4\ntolerance: 0.1\nalgebraic_loops: refuse");
  same("mass: $weight", "mass: = weight");
}

TEST_CASE("values that are near are a difference, as are words in quotes and signals in another place") {
  CHECK(lines(loop_yaml, with(loop_yaml, "step: 1 ms", "step: 1.0000001 ms")).size() == 1);
  CHECK(lines(loop_yaml, with(loop_yaml, "[push, spring]", "[spring, push]")).size() == 2);
  CHECK(lines(loop_yaml, with(loop_yaml, "3 N", "3 kN")).size() == 1);
  CHECK(lines(loop_yaml, with(loop_yaml, "3 N", "3 m")).size() == 1);
  CHECK(lines(loop_yaml, with(loop_yaml, "mass: $weight", "mass: 2 kg")).size() == 1);
}

TEST_CASE("the facts of files with one meaning are one text") {
  Texts one, other;
  one.give("a.yaml", loop_yaml);
  other.give("a.yaml", with(loop_yaml, "title: A mass on a spring\nstep: 1 ms",
                            "step: 1 ms  # tick\ntitle: A mass on a spring"));
  FactReader reader(every_block(), one), second(every_block(), other);
  CHECK(facts_text(reader.read("a.yaml").root) == facts_text(second.read("a.yaml").root));
}

TEST_CASE("a map with the name of a solver alone is no difference, unless the map turns error control on") {
  const std::string base = "stepwire: 1\nstep: 1 ms\nstop: 1 s\nsolver: rodas\nblocks: {a: {block: Clock}}\n";
  for (const std::string same : {"rodas", "auto", "radau", "dop853", "rk4"})
    CHECK(lines(with(base, "rodas", same), with(base, "rodas", "{name: " + same + "}")).empty());
  CHECK(lines(with(base, "rodas", "dormand_prince"), with(base, "rodas", "{name: dormand_prince}")).size() ==
        1);
  CHECK(lines(base, with(base, "rodas", "{name: rodas, relative: 1e-3}")).size() == 1);
}

}  // namespace stepwire::difference
