#pragma once

#include <string>
#include <vector>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::thesis {

/// Keeps one copy of each large data file that several entries have, that of the first entry, and packs large
/// CSV files by gzip. Downloads name what is there then. Throws EnvironmentError.
void pack_data(const std::string& out, std::vector<gallery::GalleryEntry>& entries);

}  // namespace stepwire::thesis
