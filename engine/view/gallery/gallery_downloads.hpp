#pragma once

#include "engine/view/gallery/gallery.hpp"
#include "engine/view/gallery/gallery_html.hpp"
#include "engine/view/gallery/gallery_source.hpp"

namespace stepwire::gallery {

/// Returns the downloads of an entry, sorted by kind.
Html downloads_of(const GalleryEntry& entry);

/// Returns the diagram file of an entry with syntax colours and links to its parts.
Html diagram_of(const GalleryEntry& entry, const GallerySources& sources);

}  // namespace stepwire::gallery
