#pragma once

#include <string>

#include "engine/view/gallery/gallery.hpp"
#include "engine/view/gallery/gallery_source.hpp"

namespace stepwire::gallery {

/// Returns the page of one entry. It contains the pictures, the text of the source beside the own one,
/// claims, assumptions, downloads and the diagram file, with links to its neighbours.
std::string entry_page(const Gallery& gallery, const GallerySources& sources, std::size_t index);

}  // namespace stepwire::gallery
