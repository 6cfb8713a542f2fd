#pragma once

#include <string>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::gallery {

/// The front page: how many claims hold; summaries of chapters; which claims end otherwise than expected;
/// what disagrees with the source, what is done otherwise and what is assumed; a thumbnail of each entry, by
/// chapter.
std::string gallery_front(const Gallery& gallery);

}  // namespace stepwire::gallery
