#include "engine/app/difference/merge.hpp"

#include <catch2/catch.hpp>

#include "engine/model/diagram/load.hpp"
#include "tests/engine/app/difference/comparing.hpp"

namespace stepwire::difference {
namespace {

using Catch::Contains;
using Lines = std::vector<std::string>;

Merged merged(const std::string& ours, const std::string& theirs, const std::string& base = loop_yaml) {
  return merge(every_block(), "model.yaml", base, ours, theirs);
}

std::string everywhere(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// Merges two edits of the loop that do not meet, and compares with both in sequence.
void check_both(const std::pair<std::string, std::string>& one,
                const std::pair<std::string, std::string>& other) {
  INFO(one.second << " and " << other.second);
  const std::string ours = with(loop_yaml, one.first, one.second),
                    theirs = with(loop_yaml, other.first, other.second);
  const Merged result = merged(ours, theirs);
  CHECK(result.conflicts.empty());
  CHECK(lines(result.text, with(ours, other.first, other.second)) == Lines{});
}

}  // namespace

TEST_CASE("edits of two sides that do not meet give the same as both in sequence") {
  const std::vector<std::pair<std::string, std::string>> edits{
      {"400 N/m", "600 N/m"},
      {"amplitude: 3 N", "amplitude: 4 N"},
      {"2 Hz}", "2 Hz, phase: 1 rad}"},
      {"u: body.position", "u: body.velocity"},
      {"  sum: ", "  damper: {block: Gain, u: body.velocity, gain: -1 N s/m}\n  sum: "},
      {"record: [body.position, spring]", "record: [body.position, spring, sum]"},
      {"at_most: 0.5 m", "at_most: 1 m"},
      {"claims:\n", "claims:\n  - {that: it turns, min: body.velocity, at_most: -1 mm/s}\n"},
      {"title: A mass on a spring", "title: A mass that swings"},
      {"solver: rk4\n", "solver: rk4\nsweep: {weight: [1 kg, 2 kg]}\n"},
      {"stop: 1 s", "stop: 2 s"}};
  for (std::size_t i = 0; i < edits.size(); ++i)
    for (std::size_t k = 0; k < edits.size(); ++k)
      if (i != k) check_both(edits[i], edits[k]);
}

TEST_CASE("a block in the place of an unused one of its type is no new name for it") {
  const std::string base = with(loop_yaml, "  sum: ", "  load: {block: Constant, value: 3 N}\n  sum: ");
  const std::string exchanged =
      with(base, "load: {block: Constant, value: 3 N}", "limit: {block: Constant, value: 700 N}");
  const std::string used =
      with(base, "at_most: 0.5 m", "at_most: 0.5 m}\n  - {that: b, max: load, at_most: 9 N");
  for (const auto& result : {merged(exchanged, used, base), merged(used, exchanged, base)}) {
    REQUIRE(result.conflicts.size() == 1);
    CHECK(result.conflicts[0].at == "load");
  }
  CHECK(lines(base, exchanged).size() == 2);  // one is gone, the other new
}

TEST_CASE("a value of one side and the doc of the other merge, whichever is written short") {
  const std::string longer = with(loop_yaml, "weight: 2 kg", "weight: {value: 2 kg, doc: of it}"),
                    other = with(loop_yaml, "weight: 2 kg", "weight: 3 kg"),
                    both = with(loop_yaml, "weight: 2 kg", "weight: {value: 3 kg, doc: of it}");
  for (const auto& result : {merged(longer, other), merged(other, longer)}) {
    CHECK(result.conflicts.empty());
    CHECK(lines(result.text, both) == Lines{});
  }
}

TEST_CASE("a text with '#' in quotes merges beside changed lines") {
  const std::string claim = "at_most: 0.5 m}\n  - {that: \"a # b\", max: body.velocity, at_most: 9 m/s";
  const std::string ours = with(with(loop_yaml, "400 N/m", "600 N/m"), "amplitude: 3 N", "amplitude: 4 N");
  const std::string theirs = with(with(loop_yaml, "2 Hz}", "2 Hz, phase: 1 rad}"), "at_most: 0.5 m", claim);
  const Merged result = merged(ours, theirs);
  CHECK(result.conflicts.empty());
  CHECK_THAT(result.text, Contains("that: \"a # b\"") && Contains("phase: 1 rad"));
}

TEST_CASE("an element of a Mux that one side names is a conflict where the other side exchanges its inputs") {
  const std::string base = with(loop_yaml, "  sum: ", "  v: {block: Mux, u: [push, spring]}\n  sum: ");
  const std::string exchanged = with(base, "[push, spring]}", "[spring, push]}"),
                    longer = with(base, "[push, spring]}", "[sum, push, spring]}"),
                    named =
                        with(base, "at_most: 0.5 m", "at_most: 0.5 m}\n  - {that: b, max: v.2, at_most: 9 N");
  for (const std::string& joining : {exchanged, longer}) {
    for (const Merged& result : {merged(joining, named, base), merged(named, joining, base)}) {
      REQUIRE(result.conflicts.size() == 1);
      CHECK_THAT(result.conflicts[0].at, Catch::StartsWith("v.") && Catch::EndsWith("2"));
      CHECK(result.conflicts[0].base == "[push, spring]");
    }
  }
  // A place that took one element and takes another one, although the base names both.
  const std::string both =
      with(base, "at_most: 0.5 m",
           "at_most: 0.5 m}\n  - {that: b, max: v.2, at_most: 9 N}\n  - {that: c, max: v.1, at_most: 8 N");
  const std::string other = with(both, "max: v.2", "max: v.1");
  const std::string joined = with(both, "[push, spring]}", "[spring, push]}");
  CHECK(merged(joined, other, both).conflicts.size() == 1);
  CHECK(merged(other, joined, both).conflicts.size() == 1);
  CHECK(merged(with(base, "stop: 1 s", "stop: 2 s"), named, base).conflicts.empty());
  CHECK(merged(exchanged, with(base, "stop: 1 s", "stop: 2 s"), base).conflicts.empty());
}

TEST_CASE("a block that one side exchanges for another type leaves none of its values") {
  const std::string base =
      with(loop_yaml, "{block: Sine, amplitude: 3 N, frequency: 2 Hz}", "{block: Constant, value: 1}");
  const std::string ours = with(base, "stiffness}\n  sum", "2*stiffness}\n  sum"),
                    theirs = with(base, "{block: Constant, value: 1}", "{block: Clock}");
  for (const Merged& result : {merged(ours, theirs, base), merged(theirs, ours, base)}) {
    CHECK(result.conflicts.empty());
    CHECK_THAT(result.text, Contains("push:   {block: Clock}\n") && Contains("2*stiffness}"));
  }
}

TEST_CASE("comments and layout of ours stay") {
  const std::string ours = with(loop_yaml, "  push:   {", "  # the hand\n  push:   {");
  const Merged result = merged(ours, with(loop_yaml, "400 N/m", "600 N/m"));
  CHECK(result.text == with(ours, "400 N/m", "600 N/m"));
}

TEST_CASE("a section that the other side adds keeps its lines and comments") {
  const std::string sections =
      "# swept\nsweep:\n  weight: [1 kg, 2 kg]  # light, heavy\n\n# named\nunits:\n  push: N\n";
  const std::string ours = with(loop_yaml, "0.5 m}\n", "0.5 m}  # near\n");
  const Merged result = merged(ours, with(loop_yaml, "0.5 m}\n", "0.6 m}\n") + sections);
  CHECK(result.is_clean());
  CHECK(result.text ==
        with(ours, "0.5 m", "0.6 m") + "sweep:\n  weight: [1 kg, 2 kg]  # light, heavy\nunits:\n  push: N\n");
}

TEST_CASE("the same edit of both sides is no conflict, in another notation either") {
  const std::string ours = with(loop_yaml, "400 N/m", "600 N/m"),
                    theirs = with(loop_yaml, "400 N/m", "0.6 N/mm");
  CHECK(merged(ours, theirs).text == ours);
}

TEST_CASE("a rename on one side and a use on the other merge") {
  const std::string renamed = everywhere(loop_yaml, "body", "cart");
  const std::string used =
      with(loop_yaml, "  sum: ", "  damper: {block: Gain, u: body.velocity, gain: -1 N s/m}\n  sum: ");
  const Merged one = merged(renamed, used), other = merged(used, renamed);
  CHECK(one.is_clean());
  CHECK_THAT(one.text, Contains("damper: {block: Gain, u: cart.velocity, gain: -1 N s/m}"));
  CHECK(other.is_clean());
  CHECK(lines(one.text, other.text) == Lines{});
  CHECK(lines(other.text, everywhere(used, "body", "cart")) == Lines{});
}

TEST_CASE("one value with two new values is a conflict, which the file names with both") {
  const Merged result = merged(with(loop_yaml, "400 N/m", "600 N/m"), with(loop_yaml, "400 N/m", "500 N/m"));
  REQUIRE(result.conflicts.size() == 1);
  CHECK(result.conflicts.front().at == "stiffness.value");
  CHECK(result.conflicts.front().base == "400 N/m");
  CHECK(result.conflicts.front().ours == "600 N/m");
  CHECK(result.conflicts.front().theirs == "500 N/m");
  const yaml::Document document = yaml::parse_document(result.text, "model.yaml");
  REQUIRE(document.root.find("conflicts"));
  CHECK(document.root.find("conflicts")->items.front().find("theirs")->text == "500 N/m");
  diagram::Loader loader(every_block());
  CHECK_THROWS_WITH(
      loader.load_text(result.text, "model.yaml"),
      Contains("stiffness.value") && Contains("600 N/m") && Contains("500 N/m") && Contains("remove"));
}

TEST_CASE("a merge does not begin on unresolved conflicts") {
  const Merged result = merged(with(loop_yaml, "400 N/m", "600 N/m"), with(loop_yaml, "400 N/m", "500 N/m"));
  CHECK_THROWS_WITH(merged(result.text, loop_yaml), Contains("resolve them first"));
}

TEST_CASE("a block that one side removed and the other uses or changed is a conflict") {
  const std::string more =
      with(loop_yaml, "  sum: ", "  drag: {block: Gain, u: body.velocity, gain: -1 N s/m}\n  sum: ");
  const std::string used = with(more, "[push, spring]", "[push, spring, drag]");
  const Merged result = merged(loop_yaml, used, more);
  REQUIRE(result.conflicts.size() == 1);
  CHECK(result.conflicts.front().at == "drag");
  CHECK(result.conflicts.front().ours == "removed");
  const Merged changed = merged(loop_yaml, with(more, "-1 N s/m", "-2 N s/m"), more);
  REQUIRE(changed.conflicts.size() == 1);
  CHECK(changed.conflicts.front().at == "drag");
}

TEST_CASE("one name for two things, and two names for one, are conflicts") {
  CHECK(merged(everywhere(loop_yaml, "body", "cart"), everywhere(loop_yaml, "body", "block_of_mass"))
            .conflicts.size() == 1);
  const std::string gain = "  drag: {block: Gain, u: body.velocity, gain: -1 N s/m}\n  sum: ";
  const std::string sine = "  drag: {block: Sine, amplitude: 1 N, frequency: 5 Hz}\n  sum: ";
  CHECK(!merged(with(loop_yaml, "  sum: ", gain), with(loop_yaml, "  sum: ", sine)).conflicts.empty());
}

TEST_CASE("a new name that the other side has given to another block is a conflict in the file") {
  const std::string renamed = everywhere(loop_yaml, "body", "cart");
  const std::string theirs =
      with(loop_yaml, "  sum: ", "  cart: {block: Sine, amplitude: 1 N, frequency: 5 Hz}\n  sum: ");
  const Merged result = merged(renamed, theirs);
  REQUIRE(!result.conflicts.empty());
  CHECK(result.text.find("conflicts:") != std::string::npos);
}

TEST_CASE("a merged model with a fault that neither side has is refused") {
  const std::string ours =
      with(loop_yaml, "record: [body.position, spring]", "record: [body.position, spring]\nunits: {push: N}");
  const std::string theirs = with(loop_yaml, "amplitude: 3 N", "amplitude: 3 kg");
  const Merged result = merged(ours, theirs);
  CHECK(result.conflicts.empty());
  CHECK(!result.is_clean());
}

/// Merges a change in another place with one that exchanges the last or only thing of a section.
static void check_exchange(const std::string& base, const std::string& from, const std::string& to) {
  INFO(to);
  const std::string ours = with(base, "amplitude: 3 N", "amplitude: 4 N"), theirs = with(base, from, to);
  for (const auto& [one, other] : {std::pair{ours, theirs}, {theirs, ours}}) {
    const Merged result = merged(one, other, base);
    CHECK(result.conflicts.empty());
    CHECK(lines(result.text, with(ours, from, to)) == Lines{});
  }
}

TEST_CASE("the last block, the only entry in brackets and the only item exchanged merge with other changes") {
  const std::string end =
      "stepwire: 1\ntitle: t\nstep: 1 ms\nstop: 1 s\nunits: {push: N}\nrecord: push\n"
      "claims:\n  - {that: it moves, max: push, at_least: 0 N}\n"
      "blocks:\n  push: {block: Sine, amplitude: 3 N, frequency: 2 Hz}\n";
  const std::string flow = end + "  last: {block: Gain, u: push, gain: 2}\n";
  const std::string lines_of_block = end + "  last:\n    block: Gain\n    u: push\n    gain: 2\n";
  check_exchange(flow, "last: {block: Gain, u: push, gain: 2}", "z: {block: Constant, value: 7 m}");
  check_exchange(flow, "units: {push: N}", "units: {last: N}");
  check_exchange(flow, "{that: it moves, max: push, at_least: 0 N}",
                 "{that: other, final: last, within: 9 N}");
  check_exchange(lines_of_block, "  last:\n    block: Gain\n    u: push\n    gain: 2\n",
                 "  z: {block: Constant, value: 7 m}\n");
  check_exchange(with(lines_of_block, "3 N", "3 N"), "    gain: 2\n",
                 "    enable: push\n  more: {block: Constant, value: 1}\n");
}

TEST_CASE("two panels of one figure that the two sides change merge, also untitled and in brackets") {
  const std::string figure = "\nfigure: {panels: [{plot: lines, y: push}, {plot: lines, y: spring}]}";
  const std::string base = loop_yaml.substr(0, loop_yaml.find("\nfigure")) + figure + "\n";
  const std::string ours = with(base, "y: push", "y: [push, spring]");
  const std::string theirs = with(base, "y: spring", "y: [spring, push], y_label: force");
  const Merged result = merged(ours, theirs, base);
  CHECK(result.conflicts.empty());
  CHECK(lines(result.text, with(ours, "y: spring}", "y: [spring, push], y_label: force}")) == Lines{});
  const Merged exchanged =
      merged(with(base, "{plot: lines, y: push}", "{plot: xy, x: push, y: spring}"),
             with(base, "{plot: lines, y: spring}", "{plot: xy, x: spring, y: push}"), base);
  CHECK(exchanged.conflicts.empty());
  CHECK_THAT(exchanged.text, Contains("[{plot: xy, x: push, y: spring}, {plot: xy, x: spring, y: push}]"));
}

}  // namespace stepwire::difference
