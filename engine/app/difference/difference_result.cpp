// Fields of the differences of two diagrams.
#include "engine/app/difference/difference.hpp"

namespace stepwire::difference {

using result::Record;
using result::text_if_any;

namespace {

/// Returns a line or column; std::nullopt for 0, which is no place.
std::optional<int> number_if_any(int number) {
  return number == 0 ? std::nullopt : std::optional(number);
}

}  // namespace

static void declare(Record<Change>& is) {
  is.named("DiagramChange", "One difference in the meaning of two files.");
  is.field(
      "kind", [](const Change& of) { return word_of(of.kind); }, "added, removed, renamed, moved or changed");
  is.field("section", &Change::section, "blocks, wires, values, head, or a section of the file");
  is.field("name", &Change::name, "name of the block, parameter, input or item");
  is.field(
      "old", [](const Change& of) { return text_if_any(of.from); },
      "value in the old file; null if it has none");
  is.field(
      "new", [](const Change& of) { return text_if_any(of.to); },
      "value in the new file; null if it has none");
  is.field("ratio", &Change::ratio, "new number over old number; null for other values");
  is.field(
      "before_line", [](const Change& of) { return number_if_any(of.before.line); },
      "line in the old file, from 1");
  is.field(
      "before_column", [](const Change& of) { return number_if_any(of.before.column); },
      "column in the old file, from 1");
  is.field(
      "after_line", [](const Change& of) { return number_if_any(of.after.line); },
      "line in the new file, from 1");
  is.field(
      "after_column", [](const Change& of) { return number_if_any(of.after.column); },
      "column in the new file, from 1");
}

static void declare(Record<FileDifference>& is) {
  is.named("FileDifference", "Differences of one file, or of one part that both diagrams use.");
  is.field("before", &FileDifference::before, "old file");
  is.field("after", &FileDifference::after, "new file");
  is.field("changes", &FileDifference::changes, "its differences");
}

void declare(Record<Difference>& is) {
  is.named("Difference", "Differences in the meaning of two diagrams.");
  is.field("equal", &Difference::is_empty, "true if both mean the same");
  is.field("files", &Difference::files, "the files that differ");
}

}  // namespace stepwire::difference
