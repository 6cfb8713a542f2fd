#pragma once

#include <string>
#include <vector>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::thesis {

/// Packs the data files in the folder of an entry: large CSV files become files of gzip, MAT files stay MAT
/// files with packed variables. The numbers stay the same. Throws EnvironmentError.
void pack_data(const std::string& folder);

/// Keeps one copy of each large data file that several entries have: that of the first entry. The downloads
/// of the others point to it. Throws EnvironmentError.
void share_data(const std::string& out, std::vector<gallery::GalleryEntry>& entries);

}  // namespace stepwire::thesis
