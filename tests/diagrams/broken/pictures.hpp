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

/// Returns wrong pictures of a file that was run.
///
/// - A panel of rows: x and y exchanged, of all rows and of each that allows it.
/// - A row: negated, and replaced by another signal.
/// - A legend, marks, texts: two texts that follow each other exchanged.
/// - A region: replaced by that of another block.
/// - A table: two cells, headings or names of rows exchanged that follow each other.
///
/// Another signal is the next one, cyclically, of the same unit and recording among those that the file draws
/// and records.
std::vector<PictureChange> picture_changes(const session::LoadedModel& model,
                                           const session::Outcome& outcome);

}  // namespace stepwire::broken
