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

/// Returns wrong pictures of a file that was run. In a panel of rows x and y are exchanged, of all rows and
/// of each that allows it. A row is negated, and replaced by another signal. In a legend, in marks and in
/// texts two neighbours are exchanged. A region is replaced by that of another block. In a table two
/// neighbours are exchanged among cells, headings and names of rows.
///
/// Another signal is the next one, cyclically, of the same unit and recording among those that the file draws
/// and records.
std::vector<PictureChange> picture_changes(const session::LoadedModel& model,
                                           const session::Outcome& outcome);

}  // namespace stepwire::broken
