#pragma once

#include <string>
#include <vector>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::thesis {

/// Writes all pictures of each chapter as one PDF if rsvg-convert is installed. A page has one picture with
/// number and caption of its figure; each figure has a bookmark.
/// Entries of a chapter must be adjacent. Entries without a PDF get a note with the reason. One call of
/// rsvg-convert makes a chapter, because its start takes longer than a picture.
void print_chapters(const std::string& out, std::vector<gallery::GalleryEntry>& entries);

}  // namespace stepwire::thesis
