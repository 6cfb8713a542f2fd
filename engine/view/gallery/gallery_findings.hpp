#pragma once

#include "engine/view/gallery/gallery.hpp"
#include "engine/view/gallery/gallery_html.hpp"

namespace stepwire::gallery {

/// Returns the findings over all entries: unexpected results, disagreements with the source, departures from
/// it and assumptions, each with links to the entries.
Html gallery_findings(const Gallery& gallery);

}  // namespace stepwire::gallery
