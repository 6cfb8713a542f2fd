// Orders that have a meaning: states, transitions, counters and figures.
#include <catch2/catch.hpp>

#include "engine/app/difference/merge.hpp"
#include "engine/app/language/tree_edits.hpp"
#include "tests/engine/app/difference/comparing.hpp"

namespace stepwire::difference {
namespace {

using Catch::Contains;

const std::string chart =
    "stepwire: 1\ntitle: A chart\nstep: 10 ms\nstop: 1 s\nblocks:\n  r: {block: Ramp, slope: 1}\n"
    "  net: {block: Sum, u: [r, m], signs: \"++\"}\n  m:\n    block: StateMachine\n    u: r\n    states:\n"
    "      off: {output: 0, to: {low: u > 0.5, high: u > 0.4}}\n"
    "      low: {output: 1, to: {off: u > 5}}\n      high: {output: 2, to: {off: u > 5}}\n"
    "record: [r, m.y]\nfigure:\n  - {plot: lines, x: time in s, y: r}\n"
    "  - {plot: lines, x: time in s, y: m.y}\n"
    "claims:\n  - {that: it is small, max: figure.1.y, at_most: 2}\n";

const std::string low = "      low: {output: 1, to: {off: u > 5}}\n";
const std::string high = "      high: {output: 2, to: {off: u > 5}}\n";

/// Returns the chart with another first state.
std::string beginning_with(const std::string& state) {
  return with(with(chart, state, ""), "    states:\n", "    states:\n" + state);
}

Merged merged(const std::string& ours, const std::string& theirs) {
  return merge(every_block(), "model.yaml", chart, ours, theirs);
}

}  // namespace

TEST_CASE("the order of states, transitions and figures is a difference") {
  CHECK_THAT(lines(chart, beginning_with(low)).at(0),
             Contains("order") && Contains("m.states") && Contains("off, low, high -> low, off, high"));
  const std::string turned =
      with(chart, "to: {low: u > 0.5, high: u > 0.4}", "to: {high: u > 0.4, low: u > 0.5}");
  CHECK_THAT(lines(chart, turned).at(0), Contains("low, high -> high, low"));
  const std::string first = "  - {plot: lines, x: time in s, y: r}\n";
  const std::string swapped = with(with(chart, first, ""), "claims:\n", first + "claims:\n");
  CHECK_THAT(lines(chart, swapped).at(0), Contains("order of figure") || Contains("figure"));
}

TEST_CASE("a merge keeps an order that one side changes, and names both orders where both do") {
  const std::string other = with(chart, "stop: 1 s", "stop: 2 s");
  const Merged taken = merged(other, beginning_with(low));
  CHECK(taken.is_clean());
  CHECK(lines(with(beginning_with(low), "stop: 1 s", "stop: 2 s"), taken.text).empty());
  const Merged both = merged(beginning_with(high), beginning_with(low));
  REQUIRE(both.conflicts.size() == 1);
  CHECK(both.conflicts[0].at == "order of blocks.m.states");
  CHECK(both.conflicts[0].base == "off, low, high");
  CHECK(both.conflicts[0].ours == "high, off, low");
  CHECK(both.conflicts[0].theirs == "low, off, high");
  CHECK_THAT(both.text, Contains("\nconflicts:\n") && Contains("theirs: \"low, off, high\""));
}

TEST_CASE("a figure that one side inserts stands before one that the other side edits") {
  const std::string at = "  - {plot: lines, x: time in s, y: m.y}\n";
  const std::string added = "  - {plot: lines, x: time in s, y: net}\n";
  const std::string old_edge = "  # the answer\n" + at;
  const std::string base = with(chart, at, old_edge);
  for (const std::string edit : {"y: m.y, y_label: answer", "y: m.y, title: answer"}) {
    const std::string edited = with(with(base, "y: m.y}", edit + "}"), "slope: 1", "slope: 3");
    const std::string inserted = with(base, old_edge, added + old_edge);
    const std::string right = with(edited, "  # the answer\n", added + "  # the answer\n");
    for (const Merged& one : {merge(every_block(), "model.yaml", base, edited, inserted),
                              merge(every_block(), "model.yaml", base, inserted, edited)}) {
      CHECK(one.is_clean());
      CHECK(one.text == right);
    }
  }
}

TEST_CASE("states that one side reorders keep the edits of the other side") {
  const std::string edited = with(chart, "low: {output: 1", "low: {output: 3");
  const Merged one = merged(edited, beginning_with(low)), other = merged(beginning_with(low), edited);
  const std::string right = with(beginning_with(low), "low: {output: 1", "low: {output: 3");
  CHECK(one.is_clean());
  CHECK(one.text == right);
  CHECK(other.text == right);
}

TEST_CASE("figures that both sides insert are a conflict of their order") {
  const std::string edge = "  - {plot: lines, x: time in s, y: r}\n";
  const std::string ours = with(chart, edge, "  - {plot: lines, x: time in s, y: net}\n" + edge),
                    theirs = with(chart, edge, edge + "  - {plot: lines, x: time in s, y: r, title: T}\n");
  const Merged result = merged(ours, theirs);
  REQUIRE(result.conflicts.size() == 1);
  CHECK(result.conflicts[0].at == "order of figure");
  CHECK_THAT(result.text, Contains("title: T") && Contains("y: net"));
}

TEST_CASE("a version that is cut short is merged with its faults, which are told") {
  const std::string cut = chart.substr(0, chart.find("blocks:"));
  const Merged result = merged(chart, cut);
  REQUIRE_FALSE(result.is_clean());
  CHECK_THAT(result.faults.at(0).text(), Contains("blocks are missing"));
}

TEST_CASE("what belongs together by place in a block is not merged key by key") {
  // a - b on one side, b + a on the other: b - a is neither.
  const std::string ours = with(chart, "signs: \"++\"", "signs: \"+-\"");
  const std::string theirs = with(chart, "u: [r, m], signs", "u: [m, r], signs");
  CHECK(merged(ours, theirs).conflicts.size() == 1);
  CHECK(merged(theirs, ours).conflicts.size() == 1);
}

}  // namespace stepwire::difference
