#pragma once

#include <string>
#include <vector>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::thesis {

/// Writes all pictures of each chapter as one PDF, a page each, where the program for that is installed: to
/// start it takes longer than to draw a picture. Entries that have none get a note that says why. Entries of
/// a chapter stand together.
void print_chapters(const std::string& out, std::vector<gallery::GalleryEntry>& entries);

}  // namespace stepwire::thesis
