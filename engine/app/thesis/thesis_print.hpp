#pragma once

#include <string>
#include <vector>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::thesis {

/// Writes all pictures of each chapter as one PDF where rsvg-convert is installed: a page for each picture,
/// with number and caption of its figure, and a bookmark for each figure. Entries of a chapter follow each
/// other. Entries without a PDF get a note with the reason. One call of rsvg-convert makes a chapter, because
/// its start takes longer than a picture.
void print_chapters(const std::string& out, std::vector<gallery::GalleryEntry>& entries);

}  // namespace stepwire::thesis
