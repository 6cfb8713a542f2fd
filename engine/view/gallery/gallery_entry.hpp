#pragma once

#include <string>

#include "engine/view/gallery/gallery.hpp"
#include "engine/view/gallery/gallery_source.hpp"

namespace stepwire::gallery {

/// The page of one entry: its pictures, what the source says of it beside what is said here, claims, what is
/// assumed, files to take along and its diagram file; with ways to its neighbours.
std::string entry_page(const Gallery& gallery, const GallerySources& sources, std::size_t index);

}  // namespace stepwire::gallery
