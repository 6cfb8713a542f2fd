#pragma once

#include "engine/view/gallery/gallery.hpp"
#include "engine/view/gallery/gallery_html.hpp"
#include "engine/view/gallery/gallery_source.hpp"

namespace stepwire::gallery {

/// What a reader may take along of an entry, by what it is.
Html downloads_of(const GalleryEntry& entry);

/// The diagram file of an entry in colours, with links to the parts that it uses.
Html diagram_of(const GalleryEntry& entry, const GallerySources& sources);

}  // namespace stepwire::gallery
