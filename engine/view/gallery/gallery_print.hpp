#pragma once

#include <string>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::gallery {

/// Returns the page of one picture of an entry as SVG: the picture, and below it the number and the caption
/// of the figure. `svg` is the text of the picture.
std::string printed_page(const GalleryEntry& entry, const GalleryPicture& picture, const std::string& svg);

/// Returns the name of an entry in a list of pages: "Figure 15: The force over a 1-D map".
std::string printed_name(const GalleryEntry& entry);

}  // namespace stepwire::gallery
