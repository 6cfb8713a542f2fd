#include <catch2/catch.hpp>

#include "tests/engine/app/language/editing.hpp"

namespace stepwire::language {

namespace {

const std::string part =
    "stepwire: 1\ntitle: a spring\ninputs: {x: {unit: m}}\noutputs: {force: k}\nparameters: {c: 2 N/m}\n"
    "blocks:\n  k: {block: Gain, gain: $c, u: x}\n";
const std::string whole =
    file_head +
    "parameters: {mass: {value: 2 kg, at_least: 1 kg}}\n"
    "record: [body.position, rig.force, {every: 2 ms, signals: [{p: body.velocity}]}]\n"
    "sweep: {rig.c: {from: 1 N/m, to: 2 N/m, count: 2}}\n"
    "stop_when: body.position > 5 m && time > 1 s\n"
    "figure: [{plot: lines, x: time, y: [body.position in mm, {signal: body.position in mm, label: b}]},\n"
    "  {plot: diagram, open: rig, hide: [rig.k]}]\n"
    "scene: {view: {x: [-1 m, 1 m], y: [-1 m, 1 m]}, objects: {hand: {ball: [body.position, 0 m], radius: 5 "
    "mm}}}\n"
    "claims:\n  - {that: it rests, final: abs(body.position), at_most: 4 m}\n"
    "units: {body.velocity: m/s}\n"
    "blocks:\n  rig: {diagram: spring.yaml, x: body.position, c: 1 N/m}\n"
    "  turned: {block: Sum, signs: \"-+\", u: [rig, push]}\n  push: {block: Constant, value: 1 N}\n"
    "  body: {block: Mass, mass: $mass, force: turned, initial_position: 1 m}\n";

/// All that an editor may send for at a place of a text.
void look_at(Editing& editing, const std::string& text, std::size_t at) {
  editing.open("a.yaml", text);
  static_cast<void>(editing.diagnostics("a.yaml"));
  const std::string file = editing.path("a.yaml");
  const EditorPosition place = TextPlaces(text).position(at);
  LanguageService& service = editing.service();
  static_cast<void>(service.completions(file, place));
  static_cast<void>(service.hover(file, place));
  static_cast<void>(service.definition(file, place));
  static_cast<void>(service.mendings(file, {{0, 0}, place}));
  static_cast<void>(service.outline(file));
  static_cast<void>(service.shapes(file));
}

}  // namespace

TEST_CASE("a text of which any line is missing is looked at as far as it goes") {
  Editing editing;
  editing.write("spring.yaml", part);
  for (std::size_t from = 0; from < whole.size(); from = whole.find('\n', from) + 1) {
    const std::size_t end = whole.find('\n', from) + 1;
    INFO(whole.substr(from, end - from));
    look_at(editing, whole.substr(0, from) + whole.substr(end), from);
  }
  look_at(editing, whole, whole.size());
  CHECK(editing.wrong("a.yaml").empty());
}

TEST_CASE("a text that ends anywhere, or has a letter less anywhere, is looked at as far as it goes") {
  Editing editing;
  editing.write("spring.yaml", part);
  for (std::size_t at = 3; at < whole.size(); at += 5) {
    look_at(editing, whole.substr(0, at), at);
    look_at(editing, whole.substr(0, at) + whole.substr(at + 1), at);
  }
  editing.open("a.yaml", file_head + "blocks:\n  one: {block: Constant, value: 1}\nrecord: [one]\n");
  CHECK(editing.wrong("a.yaml").empty());
}

TEST_CASE("a stop condition on what is not there is marked") {
  Editing editing;
  editing.open("a.yaml", file_head +
                             "record: [one]\nstop_when: ghost > time\nblocks:\n  one: {block: Constant, "
                             "value: 1}\n");
  REQUIRE(editing.wrong("a.yaml").size() == 1);
  CHECK_THAT(editing.wrong("a.yaml")[0], Catch::Matchers::Contains("ghost"));
}

}  // namespace stepwire::language
