#pragma once

#include <map>
#include <string>

#include "engine/view/gallery/gallery.hpp"
#include "engine/view/gallery/gallery_html.hpp"

namespace stepwire::gallery {

/// The diagram files of a gallery, each once, by their places in it.
using GallerySources = std::map<std::string, std::string>;

GallerySources sources_of(const Gallery& gallery);

/// The place of the page that shows a diagram file.
std::string page_of_source(const std::string& path);

/// A diagram file in colours, for a page of the gallery; the parts that it uses are links to their pages.
Html painted_source(const std::string& page, const std::string& path, const GallerySources& sources);

/// The page of a diagram file, with links to the entries that use it.
std::string source_page(const Gallery& gallery, const GallerySources& sources, const std::string& path);

}  // namespace stepwire::gallery
