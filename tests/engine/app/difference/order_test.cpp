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

TEST_CASE("a merge keeps an order that one side changes, or refuses") {
  const std::string other = with(chart, "stop: 1 s", "stop: 2 s");
  const Merged taken = merged(other, beginning_with(low));
  CHECK(taken.is_clean());
  CHECK(lines(with(beginning_with(low), "stop: 1 s", "stop: 2 s"), taken.text).empty());
  CHECK_THROWS_WITH(merged(beginning_with(high), beginning_with(low)),
                    Contains("blocks.m.states") && Contains("merge it by hand"));
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
