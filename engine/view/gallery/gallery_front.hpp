#pragma once

#include <string>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::gallery {

/// Returns the front page. It contains the count of claims that hold, summaries of chapters, unexpected
/// results, disagreements, departures, assumptions, and a thumbnail of each entry by chapter.
std::string gallery_front(const Gallery& gallery);

}  // namespace stepwire::gallery
