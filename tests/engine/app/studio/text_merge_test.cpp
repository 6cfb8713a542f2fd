#include "engine/app/studio/text_merge.hpp"

#include <catch2/catch.hpp>

namespace stepwire::studio {

namespace {

std::string merged(const std::string& base, const std::string& ours, const std::string& theirs) {
  const TextMerge result = merge(base, ours, theirs);
  CHECK(result.is_clean);
  return changed(ours, result.changes);
}

std::string both(const std::string& base, const std::string& ours, const std::string& theirs) {
  const TextMerge result = merge(base, ours, theirs);
  CHECK_FALSE(result.is_clean);
  return changed(ours, result.changes);
}

}  // namespace

TEST_CASE("lines that only one of two texts has changed are in the merged one") {
  CHECK(merged("a\nb\nc\n", "A\nb\nc\n", "a\nb\nC\n") == "A\nb\nC\n");
  CHECK(merged("a\nb\nc\n", "A\nb\nc\n", "a\nB\nc\n") == "A\nB\nc\n");
  CHECK(merged("a\nb\nc\n", "a\nb\nc\nd\n", "x\na\nb\nc\n") == "x\na\nb\nc\nd\n");
  CHECK(merged("a\nb\nc\nd\n", "b\nc\nd\n", "a\nb\nd\n") == "b\nd\n");
  CHECK(merged("a\nb\nc\nd\ne\n", "1\n2\na\nb\nc\nd\ne\n", "a\nB\nc\ne\nf\n") == "1\n2\na\nB\nc\ne\nf\n");
  CHECK(merged("a\nb\nc", "A\nb\nc", "a\nb\nC\n") == "A\nb\nC\n");
  CHECK(merged("", "", "a\n") == "a\n");
  CHECK(merged("a\nb\n", "a\nb\n", "") == "");
}

TEST_CASE("the same change of both is there once, and texts in more than ASCII have their places") {
  CHECK(merged("a\nb\nc\n", "A\nb\nC\n", "A\nb\nc\n") == "A\nb\nC\n");
  CHECK(merged("a\nb\n", "a\nb\nc\n", "a\nb\nc\n") == "a\nb\nc\n");
  CHECK(merged("\u03a9 \U0001f600\nb\nc\nd\n", "\u03a9 \U0001f600!\nb\nc\nd\n",
               "\u03a9 \U0001f600\nb\nC\nd\n") == "\u03a9 \U0001f600!\nb\nC\nd\n");
}

TEST_CASE("where both changed the same lines ours stay, and the others follow as comments") {
  CHECK(both("a\n  b: 1\nc\n", "a\n  b: 2\nc\n", "a\n  b: 3\nc\n") ==
        "a\n  b: 2\n  # in the file: b: 3\nc\n");
  CHECK(both("a\nb\nc\n", "a\nc\n", "a\nB\nc\n") == "a\n# in the file: B\nc\n");
  CHECK(both("a\n", "a\nx\n", "a\ny\n") == "a\nx\n# in the file: y\n");
  CHECK(both("a", "b", "c") == "b\n# in the file: c");
  CHECK(both("a\nb\nc\nd\ne\n", "a\nB\nc\nd\ne\n", "a\nx\nc\nd\nE\n") == "a\nB\n# in the file: x\nc\nd\nE\n");
  CHECK(both("a\nb\nc\n", "a\nB\nc\n", "a\nc\n") == "a\nB\nc\n");
}

TEST_CASE("two texts of which the origin is not known keep all lines of both") {
  const std::string ours = "a\nb\nd\n", theirs = "a\nc\nd\ne\n";
  const TextMerge result = merge(ours, theirs);
  CHECK_FALSE(result.is_clean);
  CHECK(changed(ours, result.changes) == "a\nb\n# in the file: c\nd\ne\n");
}

}  // namespace stepwire::studio
