#pragma once

#include <string>
#include <vector>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::thesis {

/// Keeps one copy of each large CSV file that several entries have, in the first entry, and compresses the
/// largest by gzip. Updates the downloads accordingly. Throws EnvironmentError.
void pack_data(const std::string& out, std::vector<gallery::GalleryEntry>& entries);

}  // namespace stepwire::thesis
