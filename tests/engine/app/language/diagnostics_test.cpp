#include <catch2/catch.hpp>

#include "tests/engine/app/language/editing.hpp"

namespace stepwire::language {
using Catch::Matchers::Contains;

TEST_CASE("what is wrong is marked from its first to its last character") {
  Editing editing;
  editing.open("a.yaml", file_head +
                             "record: [lag]\nblocks:\n  one: {block: Constant, value: 1}\n  lag: {block: "
                             "Lag, u: oen, tua: 1 s, tau: -1 s}\n");
  const auto wrong = editing.wrong("a.yaml");
  REQUIRE(wrong.size() == 3);
  CHECK_THAT(wrong[0],
             Contains("oen: lag.u: there is no block 'oen'") || Contains("tua: lag: Lag has no 'tua'"));
  for (const std::string start : {"oen: lag.u: there is no", "tua: lag: Lag has no", "-1 s: lag.tau: -1"})
    CHECK(std::ranges::any_of(wrong, [&](const std::string& one) { return one.starts_with(start); }));
}

TEST_CASE("a text that is no YAML has one fault, which goes once it is mended") {
  Editing editing;
  editing.open("a.yaml", file_head + "blocks:\n  one: {block: Constant, value: 1\n");
  CHECK(editing.diagnostics("a.yaml").size() == 1);
  editing.open("a.yaml", file_head + "record: [one]\nblocks:\n  one: {block: Constant, value: 1}\n");
  CHECK(editing.diagnostics("a.yaml").empty());
}

TEST_CASE("a YAML file that is no diagram is left alone") {
  Editing editing;
  editing.open("other.yaml", "on: push\njobs: [{run: make}]\nrecord: {x: 1}\n");
  CHECK(editing.diagnostics("other.yaml").empty());
}

TEST_CASE("the text in the editor counts, not that on the disk, also of a part") {
  Editing editing;
  const std::string part =
      "stepwire: 1\ntitle: p\ninputs: {x: }\noutputs: {y: k}\nblocks:\n  k: {block: Gain, gain: 2, u: x}\n";
  editing.write("part.yaml", part);
  editing.open("a.yaml", file_head +
                             "record: [rig]\nblocks:\n  one: {block: Constant, value: 1}\n  rig: {diagram: "
                             "part.yaml, x: one}\n");
  CHECK(editing.wrong("a.yaml").empty());
  std::string broken = part;
  broken.replace(broken.find("gain: 2"), 4, "gian");
  editing.open("part.yaml", broken);
  REQUIRE(editing.wrong("part.yaml").size() == 1);
  CHECK_THAT(editing.wrong("part.yaml")[0], Contains("gian: k: Gain has no 'gian'"));
  REQUIRE(editing.wrong("a.yaml").size() == 1);
  CHECK_THAT(editing.wrong("a.yaml")[0], Contains("part.yaml: in part.yaml: "));
  editing.open("part.yaml", part);
  CHECK(editing.wrong("a.yaml").empty());
  CHECK(editing.wrong("part.yaml").empty());
}

TEST_CASE("a part of a repository that is not fetched is marked with the call that fetches it") {
  Editing editing;
  const std::string rev(40, 'a'), sha256(64, 'b');
  editing.open("a.yaml", file_head + "uses:\n  rig: {git: lib, rev: " + rev + ", sha256: " + sha256 +
                             "}\nrecord: [one]\nblocks:\n  one: {block: Constant, value: 1}\n"
                             "  part: {diagram: rig/spring, x: one}\n");
  const auto wrong = editing.wrong("a.yaml");
  REQUIRE(wrong.size() == 1);
  CHECK_THAT(wrong[0], Contains("uses.rig: rig at " + rev + " is not fetched; `stepwire fetch ") &&
                           Contains("a.yaml` fetches it"));
}

TEST_CASE("a part that is open alone is checked as one that is used") {
  Editing editing;
  editing.open("part.yaml",
               "stepwire: 1\ntitle: p\ninputs: {x: {unit: m}}\noutputs: {y: k}\nblocks:\n  k: {block: Gain, "
               "gain: 2, u: x}\n");
  CHECK(editing.wrong("part.yaml").empty());
}

TEST_CASE("every word that was probably meant is put by a change that leaves all else as it is") {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"record: [lag]\nblocks:\n  one: {block: Constant, value: 1}\n  lag: {block: Lgag, u: one, tau: 1 s}\n",
       "Lag"},
      {"record: [lga]\nblocks:\n  one: {block: Constant, value: 1}\n  lag: {block: Lag, u: one, tau: 1 s}\n",
       "lag"},
      {"record: [lag]\nblocks:\n  one: {block: Constant, value: 1}\n  lag: {block: Lag, u: one.yy, tau: 1 "
       "s}\n",
       "y"},
      {"parameters: {time_c: 1 s}\nrecord: [lag]\nblocks:\n  one: {block: Constant, value: 1}\n  lag: "
       "{block: Lag, u: one, tau: $time_d}\n",
       "time_c"},
      {"record: [lag]\nclaim: []\nblocks:\n  lag: {block: Constant, value: 1}\n", "claims"},
      {"record: [lag]\nclaims: [{that: x, finl: lag, at_most: 2}]\nblocks:\n  lag: {block: Constant, value: "
       "1}\n",
       "final"},
      {"record: [lag]\nclaims: [{that: x, max: \"2*lga + 1\", at_most: 2}]\nblocks:\n  lag: {block: "
       "Constant, value: 1}\n",
       "lag"},
      {"record: [lag]\nfigure: {plot: lins, x: time, y: lag}\nblocks:\n  lag: {block: Constant, value: 1}\n",
       "lines"}};
  for (const auto& [body, meant] : cases) {
    Editing editing;
    editing.open("a.yaml", file_head + body);
    const auto all = editing.service().mendings(editing.path("a.yaml"), {{0, 0}, {99, 0}});
    INFO(body);
    REQUIRE(all.size() == 1);
    CHECK(all[0].text == meant);
    const TextPlaces places(editing.text("a.yaml"));
    editing.open(
        "a.yaml",
        spliced(editing.text("a.yaml"),
                {{{places.offset(all[0].range.start), places.offset(all[0].range.end)}, all[0].text}}));
    CHECK(editing.wrong("a.yaml").empty());
  }
}

}  // namespace stepwire::language
