#pragma once

#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"

namespace stepwire {

/// Returns the disagreements between the texts of pictures and what is drawn. One fault is one sentence.
///
/// - An axis label that begins with a quantity, as "force of the hand", needs the unit of that quantity.
///
/// - A coordinate in a label, as x or F_y, needs a row that names this coordinate.
///
/// - Words that are opposites, as first and second, are the same in texts and in signals.
///
/// - A panel with a title of its own is under titles with all words that its `where` selects.
///
/// - A number in a title is in the file: the value of a parameter, a swept value, the number of swept values,
///   or a number in `where`.
std::vector<std::string> text_faults(const session::LoadedModel& model);

/// Returns the labels of axes of which no word names a known quantity.
std::vector<std::string> unknown_labels(const session::LoadedModel& model);

}  // namespace stepwire
