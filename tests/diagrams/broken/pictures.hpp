#pragma once

#include <string>
#include <vector>

#include "engine/app/session/outcome.hpp"

namespace stepwire::broken {

/// A section `figure` with a row, text or region in another's place.
struct ChangedSection {
  yaml::Node figure;
  std::string with{};  ///< what takes the place
};

/// One wrong picture.
struct PictureChange {
  std::string what;  ///< "figure.2.1.y.2 negated"
  std::size_t picture = 0;
  std::vector<ChangedSection> sections{};  ///< the first that is not refused counts
};

/// Wrong pictures of a file that was run. In each panel of rows: x and y exchanged, of all rows and of each
/// that allows it; each row negated; each row replaced by another signal; two texts of the legend, or of
/// points, exchanged; another region. In each table: two cells, headings or names of rows exchanged. Another
/// signal is the next one, cyclically, of the same unit and recording among those that the file draws and
/// records.
std::vector<PictureChange> picture_changes(const session::LoadedModel& model,
                                           const session::Outcome& outcome);

}  // namespace stepwire::broken
