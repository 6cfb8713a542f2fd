#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::thesis {

/// Front page of a gallery, and the order of its entries.
struct ThesisContents {
  std::string title, introduction;
  std::map<int, int> tables;  ///< number of a table to the number of the figure that it follows in the text
  std::vector<gallery::ChapterSummary> summaries;

  /// Returns the sort key of an entry: (figure, 0) for a figure, (preceding figure, number) for a table.
  /// Entries that are neither, and tables that are not listed, sort last.
  std::pair<int, int> place_of(const gallery::GalleryEntry& entry) const;
};

/// Reads gallery/contents.yaml in the folder. Throws Error.
ThesisContents read_contents(const std::string& diagrams);

}  // namespace stepwire::thesis
