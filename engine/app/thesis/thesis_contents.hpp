#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::thesis {

/// What the gallery of a folder of diagram files says on its front page, and in which order they stand.
struct ThesisContents {
  std::string title, introduction;
  std::map<int, int> tables;  ///< number of a table, and of the figure behind which it stands in the text
  std::vector<gallery::ChapterSummary> summaries;

  /// Where an entry stands: behind which figure, and tables behind the figure itself; what is neither figure
  /// nor table, or a table that is not named here, comes last.
  std::pair<int, int> place_of(const gallery::GalleryEntry& entry) const;
};

/// Reads gallery/contents.yaml in the folder. Throws Error.
ThesisContents read_contents(const std::string& diagrams);

}  // namespace stepwire::thesis
