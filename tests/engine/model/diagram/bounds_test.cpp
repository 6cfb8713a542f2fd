// Structures of excessive size are refused before they take time or memory.
#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::diagram {
using Catch::Matchers::Contains;

namespace {

constexpr int many = 20'000;

std::string numbered(const std::string& before, int count, const std::string& after) {
  std::string text;
  for (int i = 0; i < count; ++i) text += before + std::to_string(i) + after;
  return text;
}

}  // namespace

TEST_CASE(
    "parameters that each use the next are refused beyond a thousand, and in the other order they may be "
    "more") {
  std::string rising, falling = "parameters:\n";
  for (int i = 0; i < 14'000; ++i) {
    falling += "  p" + std::to_string(i) + ": = p" + std::to_string(i + 1) + "\n";
    rising += "  p" + std::to_string(i + 1) + ": = p" + std::to_string(i) + "\n";
  }
  const auto refused = faults_of(falling + "  p14000: 1\nblocks: {c: {block: Constant, value: $p0}}\n");
  REQUIRE_FALSE(refused.empty());
  CHECK_THAT(refused.front(), Contains("through more than 1000 parameters that use each other"));
  CHECK(faults_of("parameters:\n  p0: 1\n" + rising + "blocks: {c: {block: Constant, value: $p14000}}\n")
            .empty());
}

TEST_CASE("parts that use the next one twice are refused where they are too many") {
  const DiagramFolder folder;
  for (int i = 0; i < 31; ++i) {
    const std::string next = "{diagram: part" + std::to_string(i + 1) + ".yaml}";
    folder.write("part" + std::to_string(i) + ".yaml",
                 "stepwire: 1\nstep: 1 s\nstop: 1 s\nsolver: rk4\noutputs: {y: a.y}\nblocks:\n  a: " + next +
                     "\n  b: " + next + "\n");
  }
  folder.write("part31.yaml", "stepwire: 1\noutputs: {y: c}\nblocks:\n  c: {block: Constant, value: 1}\n");
  const auto refused = folder.faults("part0.yaml");
  REQUIRE(refused.size() == 1);
  CHECK_THAT(refused.front(), Contains("the diagram has more than 100000 parts here"));
}

TEST_CASE("of twenty thousand misspelt names a hundred are listed", "[full]") {
  std::string gains = "blocks:\n";
  for (int i = 0; i < many; ++i)
    gains += "  block" + std::to_string(i) + ": {block: Gain, gain: 2, u: blocc" + std::to_string(i) + "x}\n";
  const auto refused = faults_of(gains);
  REQUIRE(refused.size() == 101);
  CHECK_THAT(refused.front(), Contains("there is no block 'blocc0x'; did you mean 'block0'?"));
  CHECK(refused.back() == "there may be more than these 100 faults");
  const std::string constants = "blocks:\n" + numbered("  a", many, ": {block: Constant, value: 1}\n");
  CHECK(faults_of(constants + "record: [" + numbered("aa", many, "x, ") + "a0]\n").size() == 101);
}

}  // namespace stepwire::diagram
