#pragma once

#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/view/gallery/gallery.hpp"

namespace stepwire::thesis {

/// Fills in the entry from the diagram file: label, title, captions, departures, assumed values.
void describe_entry(const session::LoadedModel& model, gallery::GalleryEntry& entry);

/// Returns copies of the diagram file and of its parts, at their paths relative to `root`. They can be run
/// from the gallery.
std::vector<gallery::GallerySource> sources_of(const session::LoadedModel& model, const std::string& root);
gallery::GallerySource source_of(const std::string& file, const std::string& root);

/// Adds the pictures that a run wrote into its folder under `out`, with sizes and captions. Also writes a
/// script that contains their texts. Throws EnvironmentError.
void add_pictures(const session::LoadedModel& model, const std::vector<std::string>& files,
                  const std::string& out, gallery::GalleryEntry& entry);

/// Adds every file in the folder of an entry as a download.
void add_downloads(const std::string& out, gallery::GalleryEntry& entry);

}  // namespace stepwire::thesis
