#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/engine/app/language/editing.hpp"

namespace stepwire::language {

namespace {

using Labels = std::vector<std::string>;

std::ptrdiff_t place(const Labels& all, const std::string& label) {
  const auto found = std::ranges::find(all, label);
  return found == all.end() ? 1'000'000 : found - all.begin();
}

bool has(const Labels& all, const std::string& label) {
  return place(all, label) < 1'000'000;
}

}  // namespace

TEST_CASE("signals whose unit fits come first, then those of no known unit, then the others") {
  Editing editing;
  editing.open("a.yaml",
               file_head +
                   "parameters: {stiff: 2 N/m, load: 3 N}\nblocks:\n  a: {block: Constant, value: 1 m}\n"
                   "  b: {block: Constant, value: 1}\n  c: {block: Constant, value: $load}\n"
                   "  body: {block: Mass, mass: 1 kg, force: }\n");
  const Labels all = editing.labels("a.yaml", "force: }", 7);
  CHECK(place(all, "c") < place(all, "b"));
  CHECK(place(all, "b") < place(all, "a"));
  CHECK(place(all, "$load") < place(all, "$stiff"));
  CHECK(has(all, "body.velocity"));
}

TEST_CASE("keys of a block are those of its type that are not there yet, the required ones first") {
  Editing editing;
  editing.open("a.yaml", file_head + "blocks:\n  lag: {block: Lag, u: 1, }\n  rig:\n    block: Gain\n    \n");
  const Labels keys = editing.labels("a.yaml", "u: 1, }", 6);
  CHECK(has(keys, "tau"));
  CHECK_FALSE(has(keys, "u"));
  const Labels lines = editing.labels("a.yaml", "block: Gain\n    ", 16);
  CHECK((has(lines, "gain") && has(lines, "u")));
  CHECK(place(lines, "u") < place(lines, "every"));
}

TEST_CASE("a section offers its keys and words, a plot its channels") {
  Editing editing;
  editing.open("a.yaml",
               file_head +
                   "record: [one]\nfigure: {plot: lines, }\nclaims: [{that: x, }]\nstop_when: \nblocks:\n"
                   "  one: {block: Constant, value: 1 N}\n");
  CHECK(has(editing.labels("a.yaml", "lines, }", 7), "y"));
  CHECK(has(editing.labels("a.yaml", "that: x, }", 9), "at_most"));
  CHECK(has(editing.labels("a.yaml", "solver: rk4", 8), "rk4"));
  CHECK(has(editing.labels("a.yaml", "plot: lines", 6), "scatter") ==
        has(editing.labels("a.yaml", "plot: lines", 7), "scatter"));
  CHECK(has(editing.labels("a.yaml", "stop_when: \n", 11), "one"));
}

TEST_CASE("a block's type and a part's file are completed, also where brackets are still open") {
  Editing editing;
  editing.write(
      "parts/spring.yaml",
      "stepwire: 1\ntitle: a spring\ninputs: {x: }\noutputs: {f: k}\nblocks:\n  k: {block: Gain, u: x}\n");
  editing.open("a.yaml", file_head + "blocks:\n  lag: {block: La\n  one: {block: Constant, value: 1}\n");
  CHECK(has(editing.labels("a.yaml", "block: La", 9), "Lag"));
  editing.open("a.yaml", file_head + "blocks:\n  one: {block: Constant, value: 1}\n  rig: {diagram: \n");
  CHECK(has(editing.labels("a.yaml", "diagram: ", 9), "parts/spring.yaml"));
}

TEST_CASE("a number without unit is offered the units of its key") {
  Editing editing;
  editing.open("a.yaml", file_head + "blocks:\n  lag: {block: Lag, u: 1, tau: 5 }\n");
  const Labels units = editing.labels("a.yaml", "tau: 5 ", 7);
  CHECK((has(units, "ms") && has(units, "s")));
  CHECK_FALSE(has(units, "mm"));
}

TEST_CASE("hover has the reference of blocks and keys, and units and values of names") {
  Editing editing;
  editing.open("a.yaml",
               file_head +
                   "parameters: {tau: {value: 20 ms, doc: how slow}}\nrecord: [lag]\nblocks:\n"
                   "  one: {block: Constant, value: 1 N}\n  lag: {block: Lag, u: one, tau: $tau}\n");
  using Catch::Matchers::Contains;
  CHECK_THAT(editing.hover("a.yaml", "Lag"), Contains("# Lag") && Contains("tau"));
  CHECK_THAT(editing.hover("a.yaml", "tau: $tau"), Contains("`tau`: ") && Contains("unit: s"));
  CHECK_THAT(editing.hover("a.yaml", "$tau", 2),
             Contains("20 ms") && Contains("0.02 s") && Contains("how slow"));
  CHECK_THAT(editing.hover("a.yaml", "u: one", 4), Contains("in N"));
  CHECK_THAT(editing.hover("a.yaml", "record"), Contains("signals that figures and claims read"));
  CHECK(editing.hover("a.yaml", "title: t", 7).empty());
}

TEST_CASE("in any text, at any place, completion and hover give an answer") {
  Editing editing;
  const std::string text = file_head +
                           "parameters: {k: = 2*3}\nrecord: [{every: 1 ms, signals: [a]}]\nfigure: {panels: "
                           "[{plot: lines, x: time, y: a in N}]}\n"
                           "blocks:\n  a: {block: Gain, gain: $k, u: b}  # \xce\xa9\n  b:\n    block: "
                           "\"Constant\"\n    value: [1, 2]\n";
  for (std::size_t cut = 0; cut <= text.size(); cut += 3) {
    editing.open("a.yaml", text.substr(0, cut));
    const EditorPosition end = TextPlaces(editing.text("a.yaml")).position(cut);
    CHECK_NOTHROW(editing.service().completions(editing.path("a.yaml"), end));
    CHECK_NOTHROW(editing.service().hover(editing.path("a.yaml"), end));
    CHECK_NOTHROW(editing.service().outline(editing.path("a.yaml")));
  }
}

}  // namespace stepwire::language
