#include <catch2/catch.hpp>

#include "tests/engine/app/language/editing.hpp"

namespace stepwire::language {
using Catch::Matchers::Contains;

namespace {

const std::string part =
    "stepwire: 1\ntitle: a spring\ninputs: {x: {unit: m}}\noutputs: {force: k}\nparameters: {c: 2 N/m, d: = "
    "c*2}\n"
    "blocks:\n  k: {block: Gain, gain: $c, u: x}\n  l: {block: Gain, gain: $d, u: k}\n";
const std::string user =
    file_head +
    "parameters: {mass: 2 kg}\nrecord: [body.position, rig.force, rig.k]\n"
    "sweep: {rig.c: [1 N/m, 2 N/m]}\nstop_when: body.position > 5 m\n"
    "figure: {plot: lines, x: time, y: \"body.position - 4 m in mm\", y_label: body of the rig}\n"
    "claims:\n  - {that: body rests, final: \"abs(body.position)\", at_most: 4 m}\n"
    "  - {that: it, max: rig.k, at_most: 9 N}\n"
    "units: {body.velocity: m/s}\n"
    "blocks:\n  rig: {diagram: spring.yaml, x: body.position, c: 1 N/m}\n"
    "  turned: {block: Gain, gain: -1, u: rig}\n  body: {block: Mass, mass: $mass, force: turned, "
    "initial_position: 1 m}\n";

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("a block is renamed where it is wired, recorded, drawn and claimed, and in no sentence") {
  Editing editing;
  editing.write("spring.yaml", part);
  editing.open("a.yaml", user);
  REQUIRE(editing.wrong("a.yaml").empty());
  const auto after = editing.renamed("a.yaml", "  body: {", 3, "trolley");
  REQUIRE(after.size() == 1);
  const std::string& text = after.at("a.yaml");
  CHECK(count(text, "trolley") == 7);
  CHECK_THAT(text, Contains("body of the rig") && Contains("that: body rests"));
}

TEST_CASE("a block is renamed in conditions, whose keys are completed") {
  Editing editing;
  editing.open("a.yaml", file_head +
                             "record: [g]\nblocks:\n  door: {block: Clock}\n"
                             "  g: {block: Gain, u: door, enable: {when: door > 2 s, states: reset}}\n"
                             "  h: {block: Gain, u: g, trigger: door }\n");
  REQUIRE(editing.wrong("a.yaml").empty());
  const std::string text = editing.renamed("a.yaml", "  door: {", 3, "gate").at("a.yaml");
  CHECK_THAT(text, Contains("when: gate > 2 s") && Contains("trigger: gate"));
}

TEST_CASE("a part is renamed with all that is named inside of it") {
  Editing editing;
  editing.write("spring.yaml", part);
  editing.open("a.yaml", user);
  const std::string text = editing.renamed("a.yaml", "u: rig", 4, "mount").at("a.yaml");
  CHECK_THAT(text, Contains("mount.force, mount.k") && Contains("{mount.c: [") && Contains("max: mount.k") &&
                       Contains("u: mount}") && Contains("body of the rig"));
}

TEST_CASE("what a part defines is renamed in the files that use it") {
  Editing editing;
  editing.open("spring.yaml", part);
  editing.write("a.yaml", user);
  const auto parameter = editing.renamed("spring.yaml", "{c: 2", 1, "rate");
  CHECK_THAT(parameter.at("spring.yaml"), Contains("{rate: 2 N/m, d: = rate*2}") && Contains("gain: $rate"));
  CHECK_THAT(parameter.at("a.yaml"), Contains("{rig.rate: [1 N/m") && Contains("rate: 1 N/m}"));
  const auto block = editing.renamed("spring.yaml", "  k: {", 2, "coil");
  CHECK_THAT(block.at("spring.yaml"), Contains("{force: coil}") && Contains("u: coil}"));
  CHECK_THAT(block.at("a.yaml"), Contains("rig.coil]") && Contains("max: rig.coil"));
  const auto input = editing.renamed("spring.yaml", "u: x}", 3, "stretch");
  CHECK_THAT(input.at("spring.yaml"), Contains("{stretch: {unit") && Contains("u: stretch}"));
  CHECK_THAT(input.at("a.yaml"), Contains("stretch: body.position"));
  const auto output = editing.renamed("spring.yaml", "{force: k", 1, "pull");
  CHECK_THAT(output.at("a.yaml"), Contains("rig.pull, rig.k"));
}

TEST_CASE("names are found in drawings, scenes, fits and labelled curves, and not in their labels") {
  Editing editing;
  editing.write("spring.yaml", part);
  editing.open("a.yaml",
               file_head +
                   "record: [rig, body.position]\nfigure: [{plot: lines, x: time, y: {signal: "
                   "rig.force in N, "
                   "label: rig}}, {plot: diagram, open: rig, names: {rig: my rig}, labels: {rig.force: rig}, "
                   "hide: [rig.k]}]\n"
                   "scene: {objects: {a: {ball: [rig.force/1 N*1 m, 0 m], radius: 1 mm, when: rig.k > 0}}}\n"
                   "fit: {parameters: {rig.c: {start: 1 N/m}}, compare: [{model: {signal: rig.force in N, "
                   "label: rig}, "
                   "measured: rig.force}]}\nblocks:\n  rig: {diagram: spring.yaml, x: body.position}\n"
                   "  body: {block: Mass, mass: 1 kg, force: rig}\n");
  const auto uses = editing.service().references(editing.path("a.yaml"),
                                                 editing.at("a.yaml", "1 kg, force: rig", 14), true);
  CHECK(uses.size() == 13);
}

TEST_CASE("a rename is refused where the name is taken or none, or where no name of the file stands") {
  Editing editing;
  editing.write("spring.yaml", part);
  editing.open("a.yaml", user);
  for (const std::string name : {"turned", "1a", "", "a b", "time", "x:", "\xce\xa9"})
    CHECK_THROWS_AS(editing.renamed("a.yaml", "  body: {", 3, name), EditRefused);
  CHECK_THROWS_AS(editing.renamed("a.yaml", "title", 1, "x"), EditRefused);
  CHECK_THROWS_AS(editing.renamed("a.yaml", "force: turned", 1, "x"), EditRefused);
}

TEST_CASE("a name leads to where it is defined, through the ports of parts") {
  Editing editing;
  editing.write("spring.yaml", part);
  editing.open("a.yaml", user);
  const auto place = [&](std::string_view word, std::size_t behind) {
    const auto found =
        editing.service().definition(editing.path("a.yaml"), editing.at("a.yaml", word, behind));
    REQUIRE(found);
    const std::string name = found->file.substr(editing.path("").size());
    return name + ": " + in_range(editing.text(name), found->range);
  };
  CHECK(place("force: turned", 8) == "a.yaml: turned");
  CHECK(place("$mass", 2) == "a.yaml: mass");
  CHECK(place("rig.force", 5) == "spring.yaml: force");
  CHECK(place("rig.k", 4) == "spring.yaml: k");
  CHECK(place("rig.c:", 4) == "spring.yaml: c");
  CHECK(place("x: body", 0) == "spring.yaml: x");
  CHECK(place("spring.yaml", 2) == "spring.yaml: ");
}

TEST_CASE("names in an expression are no units, and stand behind no dot of another") {
  const auto names = [](const std::string& text) {
    std::vector<std::string> all;
    for (const NameInText& one : names_in_expression(text))
      all.push_back((one.parameter ? "$" : "") + std::string(one.range.in(text)));
    return all;
  };
  using All = std::vector<std::string>;
  CHECK(names("4 N * N + 5mm - m") == All{"N", "m"});
  CHECK(names("rig.x[2] > $limit.a + 1e-3 s*rig.y.1") == All{"rig.x", "$limit", "a", "rig.y.1"});
  CHECK(names("hypot(a, b_2) ? \"W o\\rd\" : 2 1/s") == All{"hypot", "a", "b_2", "W", "o", "d"});
  CHECK(names("2.5 kg m^2/(s^3 K)*x").back() == "x");
}

}  // namespace stepwire::language
