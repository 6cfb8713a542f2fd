#pragma once

#include <string>

#include "engine/figure/gallery.hpp"

namespace stepwire {

/// What stands before the cards: how many claims hold; what is reproduced, what disagrees with the source,
/// and what is assumed, each with links to the cards.
std::string gallery_front(const Gallery& gallery);

/// The id of the card of an entry.
std::string gallery_anchor(std::size_t index);
/// Label and title of an entry as HTML.
std::string gallery_title(const GalleryEntry& entry);

}  // namespace stepwire
