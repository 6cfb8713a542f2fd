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
  bool of_text = false;  ///< labels of axes or titles are exchanged, which text_faults() reads
};

/// Returns wrong pictures of a file that was run. In a panel of rows x and y are exchanged, of all rows and
/// of each that allows it. A row is negated, and replaced by another signal. In a legend, in marks, in
/// texts and in titles two neighbours are exchanged, and two labels of axes of a panel. A region is replaced
/// by that of another block. In a table two neighbours are exchanged among cells, headings and names of rows.
///
/// Another signal is the next one, cyclically, of the same unit and recording among those that the file draws
/// and records.
std::vector<PictureChange> picture_changes(const session::LoadedModel& model,
                                           const session::Outcome& outcome);

}  // namespace stepwire::broken
