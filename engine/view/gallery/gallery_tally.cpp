#include "engine/view/gallery/gallery_tally.hpp"

namespace stepwire::gallery {

void ClaimTally::count(const GalleryEntry& entry) {
  errors += entry.error.empty() ? 0 : 1;
  for (const claim::Verdict& verdict : entry.verdicts) count(verdict);
}

void ClaimTally::count(const claim::Verdict& verdict) {
  if (verdict.kind == claim::Claim::Kind::invariant) {
    ++(verdict.holds ? invariants : broken);
    return;
  }
  ++all;
  if (verdict.surprises())
    ++surprise;
  else if (verdict.holds)
    ++hold;
  else
    ++(verdict.fails() ? fail : known);
}

std::string ClaimTally::sentence() const {
  std::string line = counted(hold, "claim holds", "claims hold");
  if (known > 0) line += fmt::format(", {} known not to", known);
  if (fail > 0) line += ", " + counted(fail, "does not hold", "do not hold");
  if (surprise > 0) line += ", " + counted(surprise, "holds after all", "hold after all");
  if (invariants > 0) line += ", " + counted(invariants, "invariant", "invariants") + " held throughout";
  if (broken > 0) line += ", " + counted(broken, "invariant is broken", "invariants are broken");
  if (errors > 0) line += ", " + counted(errors, "file did not run", "files did not run");
  return line + ".";
}

ClaimTally tally_of(const GalleryEntry& entry) {
  ClaimTally tally;
  tally.count(entry);
  return tally;
}

ClaimTally tally_of(const std::vector<GalleryEntry>& entries) {
  ClaimTally tally;
  for (const GalleryEntry& entry : entries) tally.count(entry);
  return tally;
}

std::string gallery_verdict(const std::vector<GalleryEntry>& entries) {
  return tally_of(entries).sentence();
}

std::string look_of(const claim::Verdict& verdict) {
  if (verdict.surprises() || verdict.fails()) return "bad";
  return verdict.holds ? "good" : "known";
}

std::string short_name(const GalleryEntry& entry) {
  return entry.label.empty() ? entry.title : entry.label;
}

std::string full_name(const GalleryEntry& entry) {
  return entry.label.empty() || entry.title.empty() ? entry.label + entry.title
                                                    : entry.label + ": " + entry.title;
}

std::string chapter_of(const GalleryEntry& entry) {
  return entry.section.substr(0, entry.section.find('.'));
}

std::string page_of(const GalleryEntry& entry) {
  return entry.folder + "/index.html";
}

}  // namespace stepwire::gallery
