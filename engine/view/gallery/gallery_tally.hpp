#pragma once

#include <cstddef>
#include <string>

#include "engine/view/gallery/gallery.hpp"
#include "engine/view/gallery/gallery_html.hpp"

namespace stepwire::gallery {

/// Number of claims and their results; invariants are counted separately.
struct ClaimTally {
  std::size_t all = 0, hold = 0, known = 0, fail = 0, surprise = 0, errors = 0;
  std::size_t invariants = 0, broken = 0;

  void count(const GalleryEntry& entry);
  void count(const claim::Verdict& verdict);
  bool bad() const { return fail + surprise + errors + broken > 0; }
  /// Returns the CSS class of the result: bad, known or good.
  std::string look() const { return bad() ? "bad" : known > 0 ? "known" : "good"; }
  /// Returns "6 of 7 claims hold, 1 known not to hold, 4 invariants held throughout."
  std::string sentence() const;
};

ClaimTally tally_of(const GalleryEntry& entry);
ClaimTally tally_of(const std::vector<GalleryEntry>& entries);

/// Returns the CSS class of a verdict.
std::string look_of(const claim::Verdict& verdict);

/// Returns "Figure 15", or the title of an entry without a label.
std::string short_name(const GalleryEntry& entry);
/// Returns "Figure 15: Force over a map".
std::string full_name(const GalleryEntry& entry);
/// Returns the path of its page in the gallery.
std::string page_of(const GalleryEntry& entry);

}  // namespace stepwire::gallery
