#pragma once

#include "engine/view/gallery/gallery.hpp"
#include "engine/view/gallery/gallery_html.hpp"

namespace stepwire::gallery {

/// What a reader should know of all entries: what ended otherwise than expected, what disagrees with the
/// source, what is done otherwise than there and what is assumed, each with links to the entries.
Html gallery_findings(const Gallery& gallery);

}  // namespace stepwire::gallery
