#pragma once

#include <string>
#include <vector>

#include "engine/app/difference/texts.hpp"

namespace stepwire::difference {

/// Returns the text of a file with the items of one place of orders_of() in another order, by their names.
/// Comments above an item move with it where each item begins a line. Returns the text unchanged where the
/// place has not exactly these names.
std::string rearranged(const DiagramText& file, const std::string& place,
                       const std::vector<std::string>& names);

}  // namespace stepwire::difference
