#pragma once

#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/view/gallery/gallery.hpp"

namespace stepwire::thesis {

/// What the file says of itself: label, title, captions, departures, assumed values.
void describe_entry(const session::LoadedModel& model, gallery::GalleryEntry& entry);

/// Copies of the diagram file and of the parts that it uses, which lie in the gallery as they lie around
/// `root`, so that they can be run there.
std::vector<gallery::GallerySource> sources_of(const session::LoadedModel& model, const std::string& root);
gallery::GallerySource source_of(const std::string& file, const std::string& root);

/// The pictures that a run left in its folder under `out`, with their sizes and words, and a script that has
/// their texts. Throws EnvironmentError.
void add_pictures(const session::LoadedModel& model, const std::vector<std::string>& files,
                  const std::string& out, gallery::GalleryEntry& entry);

/// Adds every file in the folder of an entry, which a reader may take along.
void add_downloads(const std::string& out, gallery::GalleryEntry& entry);

}  // namespace stepwire::thesis
