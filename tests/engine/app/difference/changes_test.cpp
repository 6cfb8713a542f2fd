#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/engine/app/difference/comparing.hpp"

namespace stepwire::difference {
namespace {

using Lines = std::vector<std::string>;

Lines changed(const std::string& from, const std::string& to) {
  return lines(loop_yaml, with(loop_yaml, from, to));
}

std::string renamed_everywhere(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace

TEST_CASE("a parameter has its old and new value, and their ratio where both have one unit") {
  CHECK(changed("400 N/m", "600 N/m") == Lines{"~ stiffness: 400 N/m -> 600 N/m (1.5 times)"});
  CHECK(changed("400 N/m", "0.2 N/mm") == Lines{"~ stiffness: 400 N/m -> 0.2 N/mm (0.5 times)"});
  CHECK(changed("amplitude: 3 N", "amplitude: 4 kg") == Lines{"~ push.amplitude: 3 N -> 4 kg"});
  CHECK(changed("frequency: 2 Hz", "frequency: 3 Hz") == Lines{"~ push.frequency: 2 Hz -> 3 Hz (1.5 times)"});
  CHECK(changed("2 Hz}", "2 Hz, phase: 1 rad}") == Lines{"~ push.phase: 0 rad (default) -> 1 rad"});
  CHECK(changed("  weight: 2 kg\n", "  weight: 2 kg\n  drag: 1 N s/m\n") == Lines{"+ drag: 1 N s/m"});
}

TEST_CASE("a wire has its old and new source") {
  CHECK(changed("u: body.position", "u: body.velocity") ==
        Lines{"~ spring.u: body.position -> body.velocity"});
  CHECK(changed("[push, spring]", "[push, body.velocity]") == Lines{"~ sum.u.2: spring -> body.velocity"});
  CHECK(changed("[push, spring]", "[push]") == Lines{"~ sum.u: [push, spring] -> [push]"});
}

TEST_CASE("a block is added or removed with what it is") {
  const std::string damper = "  damper: {block: Gain, u: body.velocity, gain: -1 N s/m}\n";
  const std::string more = with(loop_yaml, "  sum:  ", damper + "  sum:  ");
  CHECK(lines(loop_yaml, more) == Lines{"+ damper: {block: Gain, u: body.velocity, gain: -1 N s/m}"});
  CHECK(lines(more, loop_yaml) == Lines{"- damper: {block: Gain, u: body.velocity, gain: -1 N s/m}"});
  CHECK(changed("block: Sine", "block: Square") == Lines{"~ push: Sine -> Square"});
}

TEST_CASE("a rename is one line, and what follows it is none") {
  CHECK(lines(loop_yaml, renamed_everywhere(loop_yaml, "spring", "leaf")).front() == "> spring is now leaf");
  CHECK(lines(loop_yaml, renamed_everywhere(loop_yaml, "body", "cart")) == Lines{"> body is now cart"});
  CHECK(lines(loop_yaml, renamed_everywhere(loop_yaml, "stiffness", "k")) == Lines{"> stiffness is now k"});
  CHECK(lines(loop_yaml, renamed_everywhere(loop_yaml, "weight", "m")) == Lines{"> weight is now m"});
}

TEST_CASE("a renamed block may have another value as well, and all blocks of a chain another name") {
  const std::string both = with(renamed_everywhere(loop_yaml, "push", "hand"), "3 N", "4 N");
  CHECK(lines(loop_yaml, both) == Lines{"> push is now hand", "~ hand.amplitude: 3 N -> 4 N (1.333 times)"});
  std::string chain = loop_yaml;
  for (const auto& [from, to] : {std::pair{"push", "hand"},
                                 {"spring:", "leaf:"},
                                 {"spring]", "leaf]"},
                                 {"sum", "all"},
                                 {"body", "cart"}})
    chain = renamed_everywhere(chain, from, to);
  CHECK(lines(loop_yaml, chain) ==
        Lines{"> body is now cart", "> push is now hand", "> spring is now leaf", "> sum is now all"});
}

TEST_CASE("names that are exchanged between blocks of one type are a change of both") {
  const std::string two =
      with(loop_yaml, "  sum:  ", "  other: {block: Gain, u: body.velocity, gain: 5}\n  sum:  ");
  const std::string exchanged =
      with(with(with(two, "spring: {", "third: {"), "other: {", "spring: {"), "third: {", "other: {");
  CHECK(lines(two, exchanged).size() == 4);
}

TEST_CASE("records, claims, figures and the head have lines of their own") {
  CHECK(changed("[body.position, spring]", "[body.position, sum]") == Lines{"+ sum", "- spring"});
  CHECK(changed("at_most: 0.5 m", "at_most: 1 m") ==
        Lines{"~ 'it stays near'.at_most: 0.5 m -> 1 m (2 times)"});
  CHECK(changed("that: it moves", "that: it swings") == Lines{"~ 'it moves'.that: it moves -> it swings"});
  CHECK(changed("plot: lines", "plot: xy") == Lines{"~ 'lines'.plot: lines -> xy"});
  CHECK(changed("stop: 1 s", "stop: 2 s") == Lines{"~ stop: 1 s -> 2 s (2 times)"});
  CHECK(changed("solver: rk4\n", "solver: rk4\nsweep: {weight: [1 kg, 2 kg]}\n") ==
        Lines{"+ weight: [1 kg, 2 kg]"});
}

namespace {

const std::string part_yaml =
    "stepwire: 1\ntitle: a spring\nparameters: {k: 400 N/m}\ninputs: {x: {unit: m}}\noutputs: {force: "
    "spring}\n"
    "blocks:\n  spring: {block: Gain, u: x, gain: = -k}\n";

/// Returns the loop with the spring in a part.
std::string user_text() {
  return with(loop_yaml, "spring: {block: Gain, u: body.position, gain: = -stiffness}",
              "spring: {diagram: leaf.yaml, x: body.position, k: $stiffness}");
}

}  // namespace

TEST_CASE("a part that both use is compared, with its own name") {
  const Difference found = compared(user_text(), user_text(), {{"leaf.yaml", part_yaml}},
                                    {{"leaf.yaml", with(part_yaml, "gain: = -k", "gain: = -2*k")}});
  REQUIRE(found.files.size() == 1);
  CHECK(found.files.front().after == "leaf.yaml");
  CHECK(lines(found) == Lines{"~ spring.gain: = -k -> = -2*k"});
}

TEST_CASE("a part within a part is compared where the part itself is unchanged") {
  const std::string outer =
      "stepwire: 1\ntitle: a holder\nparameters: {k: 400 N/m}\ninputs: {x: {unit: m}}\n"
      "outputs: {force: leaf}\nblocks:\n  leaf: {diagram: leaf.yaml, x: x, k: $k}\n";
  const std::string user = with(user_text(), "leaf.yaml", "holder.yaml");
  const GivenFiles old_parts{{"holder.yaml", outer}, {"leaf.yaml", part_yaml}};
  const auto found_with = [&](const std::string& leaf) {
    return compared(user, user, old_parts, {{"holder.yaml", outer}, {"leaf.yaml", leaf}});
  };
  const Difference found = found_with(with(part_yaml, "gain: = -k", "gain: = -2*k"));
  REQUIRE(found.files.size() == 1);
  CHECK(found.files.front().after == "leaf.yaml");
  CHECK(lines(found) == Lines{"~ spring.gain: = -k -> = -2*k"});
  CHECK(found_with(part_yaml).is_empty());
}

TEST_CASE("parts that use each other are compared once, whatever is wrong with them") {
  const std::string around = with(part_yaml, "block: Gain, u: x, gain: = -k", "diagram: leaf.yaml, x: x");
  const Difference found = compared(user_text(), user_text(), {{"leaf.yaml", around}},
                                    {{"leaf.yaml", with(around, "400 N/m", "500 N/m")}});
  CHECK(lines(found) == Lines{"~ k: 400 N/m -> 500 N/m (1.25 times)"});
}

TEST_CASE("a port or parameter of a part with another name is one line, and its users follow") {
  std::string renamed = with(with(part_yaml, "{k:", "{rate:"), "= -k", "= -rate");
  renamed = with(with(renamed, "{x:", "{place:"), "u: x", "u: place");
  const std::string user =
      with(user_text(), "x: body.position, k: $stiffness", "place: body.position, rate: $stiffness");
  const Lines found =
      lines(compared(user_text(), user, {{"leaf.yaml", part_yaml}}, {{"leaf.yaml", renamed}}));
  CHECK(found == Lines{"> k is now rate", "> x is now place"});
  const std::string shown = with(user_text(), "record: [", "record: [spring.force, ");
  const Lines output =
      lines(compared(shown, with(shown, "spring.force", "spring.pull"), {{"leaf.yaml", part_yaml}},
                     {{"leaf.yaml", with(part_yaml, "{force:", "{pull:")}}));
  CHECK(output == Lines{"> force is now pull"});
}

TEST_CASE("a part under another name of its file is no difference where its content is the same") {
  const std::string other = with(user_text(), "leaf.yaml", "blade.yaml");
  CHECK(lines(compared(user_text(), other, {{"leaf.yaml", part_yaml}}, {{"blade.yaml", part_yaml}})) ==
        Lines{});
  CHECK(lines(compared(user_text(), other, {{"leaf.yaml", part_yaml}},
                       {{"blade.yaml", with(part_yaml, "400", "500")}}))
            .front() == "~ spring: leaf.yaml -> blade.yaml");
}

TEST_CASE("an argument of a part that repeats its default is no difference") {
  const std::string plain = with(user_text(), ", k: $stiffness", "");
  const GivenFiles parts{{"leaf.yaml", part_yaml}};
  CHECK(lines(compared(plain, with(plain, "x: body.position", "x: body.position, k: 0.4 N/mm"), parts,
                       parts)) == Lines{});
  CHECK(lines(compared(plain, with(plain, "x: body.position", "x: body.position, k: 0.5 N/mm"), parts, parts))
            .size() == 1);
}

TEST_CASE("a block that moved into a part or out of it has one line") {
  const std::string inside = with(part_yaml, "  spring: {block: Gain, u: x, gain: = -k}\n",
                                  "  spring: {block: Gain, u: x, gain: = -k}\n");
  const std::string gain = "  leaf: {block: Gain, u: body.position, gain: = -k}\n";
  std::string flat = with(loop_yaml, "stiffness: {", "k: {");
  flat = with(flat, "  spring: {block: Gain, u: body.position, gain: = -stiffness}\n", gain);
  flat = with(with(flat, "[push, spring]", "[push, leaf]"), "position, spring]", "position, leaf]");
  std::string nested = with(flat, gain, "  holder: {diagram: leaf.yaml, x: body.position, k: $k}\n");
  nested = with(with(nested, "[push, leaf]", "[push, holder]"), "position, leaf]", "position, holder]");
  const GivenFiles parts{{"leaf.yaml", inside}};
  const Lines into = lines(compared(flat, nested, parts, parts));
  CHECK(std::ranges::count(into, "> leaf moved to holder.spring") == 1);
  const Lines out = lines(compared(nested, flat, parts, parts));
  CHECK(std::ranges::count(out, "> holder.spring moved to leaf") == 1);
}

TEST_CASE("two equal blocks that moved into a part are there under their own names") {
  const std::string head = "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n  k: {block: Constant, value: 1}\n",
                    twice = "  g1: {block: Gain, u: k, gain: 2}\n  g2: {block: Gain, u: g1, gain: 2}\n";
  const std::string amplifier = "stepwire: 1\ninputs: {k: {}}\noutputs: {y: g2}\nblocks:\n" + twice;
  const Lines found = lines(compared(head + twice, head + "  amp: {diagram: amplifier.yaml, k: k}\n", {},
                                     {{"amplifier.yaml", amplifier}}));
  CHECK(std::ranges::count(found, "> g1 moved to amp.g1") == 1);
  CHECK(std::ranges::count(found, "> g2 moved to amp.g2") == 1);
}

TEST_CASE("the result has sections, values and places as data") {
  const Difference found = compared(loop_yaml, with(loop_yaml, "400 N/m", "600 N/m"));
  REQUIRE(found.files.size() == 1);
  const Change& change = found.files.front().changes.front();
  CHECK(change.section == "parameters");
  CHECK(change.ratio == 1.5);
  CHECK(change.before.line == 7);
  CHECK(result::json_of(found).text().find("\"ratio\"") != std::string::npos);
}

TEST_CASE("a block of another type has the values of both that differ, also defaults") {
  const auto text = [](const std::string& block) {
    return "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n  k: {block: Sine, amplitude: 1, frequency: 1 Hz}\n"
           "  f: " +
           block + "\nrecord: f\n";
  };
  const std::string lag = text("{block: Lag, u: k, tau: 1 s}"),
                    derivative = text("{block: Derivative, u: k}");
  CHECK(lines(lag, derivative) == Lines{"~ f: Lag -> Derivative", "~ f.tau: 1 s -> 0.001 s (default)"});
  CHECK(lines(derivative, lag) == Lines{"~ f: Derivative -> Lag", "~ f.tau: 0.001 s (default) -> 1 s"});
}

TEST_CASE("a share and a number are other values where a key takes both, and one value elsewhere") {
  const auto text = [](const std::string& within, const std::string& gain) {
    return "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n  k: {block: Constant, value: 6 N}\n"
           "  f: {block: Pulse, amplitude: 6 N, period: 1 s, width: " +
           gain + "}\nclaims: [{that: x, final: f, equals: 6 N, within: " + within + "}]\n";
  };
  CHECK(lines(text("0.01", "0.5"), text("1 %", "0.5")).size() == 1);
  CHECK(lines(text("1 %", "0.5"), text("1%", "50 %")).empty());
}

TEST_CASE("a file that cannot be read is refused") {
  CHECK_THROWS_AS(compared("stepwire: [", loop_yaml), yaml::Error);
}

/// A chain of gains with names that begin with a letter.
static std::string chain(char letter, int count, double gain, const std::string& claims = "") {
  std::string text = "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n  in: {block: Clock}\n";
  for (int i = 0; i < count; ++i)
    text += fmt::format("  {}{}: {{block: Gain, u: {}, gain: {}}}\n", letter, i,
                        i == 0 ? "in" : fmt::format("{}{}", letter, i - 1), gain + i);
  return text + claims;
}

TEST_CASE("all of many renamed blocks are found, also where each has another value") {
  for (const double gain : {2.0, 7.5}) {
    const Lines found = lines(chain('a', 300, 2.0), chain('b', 300, gain));
    for (int i = 0; i < 300; ++i)
      CHECK(std::ranges::count(found, fmt::format("> a{} is now b{}", i, i)) == 1);
    CHECK(found.size() == (gain == 2.0 ? 300 : 600));
  }
}

// Blocks of one kind are alike until the names of their neighbours are known.
TEST_CASE("one changed value among many renamed blocks exchanges no names") {
  const auto pairs = [](const char* prefix, int changed) {
    std::string text = "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n";
    for (int i = 0; i < 150; ++i)
      text += fmt::format(
          "  {0}s{1}: {{block: Constant, value: {2}}}\n  {0}g{1}: {{block: Gain, u: {0}s{1}, gain: {3}}}\n",
          prefix, i, i + 10, i == changed ? 3 : 2);
    return text;
  };
  const Lines found = lines(pairs("a", -1), pairs("b", 70));
  for (int i = 0; i < 150; ++i) CHECK(std::ranges::count(found, fmt::format("> ag{0} is now bg{0}", i)) == 1);
  CHECK(found.size() == 301);
}

TEST_CASE("one changed value in a chain of many equal blocks exchanges no names") {
  const auto equal = [](char letter, int changed) {
    std::string text = "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n  in: {block: Clock}\n";
    for (int i = 0; i < 250; ++i)
      text += fmt::format("  {}{}: {{block: Gain, u: {}, gain: {}}}\n", letter, i,
                          i == 0 ? "in" : fmt::format("{}{}", letter, i - 1), i == changed ? 3 : 2);
    return text;
  };
  const Lines found = lines(equal('a', -1), equal('b', 120));
  for (int i = 0; i < 250; ++i) CHECK(std::ranges::count(found, fmt::format("> a{0} is now b{0}", i)) == 1);
  CHECK(found.size() == 251);
}

TEST_CASE("many claims are matched by their text, then by their label") {
  std::string before = "claims:\n", after = before;
  for (int i = 0; i < 200; ++i)
    before += fmt::format("  - {{that: c{}, final: a{}, at_least: {}}}\n", i, i, i);
  for (int i = 199; i >= 0; --i)
    after += fmt::format("  - {{that: c{}, final: a{}, at_least: {}}}\n", i, i, i % 2 ? 1000 : i);
  const Lines found = lines(chain('a', 200, 2.0, before), chain('a', 200, 2.0, after));
  CHECK(found.size() == 100);
  CHECK(std::ranges::count(found, "~ 'c7'.at_least: 7 -> 1000 (142.9 times)") == 1);
}

}  // namespace stepwire::difference
