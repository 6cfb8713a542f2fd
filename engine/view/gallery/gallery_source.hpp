#pragma once

#include <functional>
#include <map>
#include <string>

#include "engine/view/gallery/gallery.hpp"
#include "engine/view/gallery/gallery_html.hpp"

namespace stepwire::gallery {

/// Function that returns the address of the page of a part, by its path in the file; an empty address without
/// a page.
using PartAddress = std::function<Address(const std::string& path)>;

/// Returns a YAML text as HTML: spans of the classes key, comment, string, number, name and type, and links
/// at its parts.
Html painted_yaml(const std::string& text, const PartAddress& part);

/// Diagram files of a gallery, each once, by their paths in it.
using GallerySources = std::map<std::string, std::string>;

GallerySources sources_of(const Gallery& gallery);

/// Returns the path of the page of a diagram file.
std::string page_of_source(const std::string& path);

/// Returns a diagram file with syntax colours, for a page of the gallery; its parts are links to their pages.
Html painted_source(const std::string& page, const std::string& path, const GallerySources& sources);

/// Returns the page of a diagram file, with links to the entries that use it.
std::string source_page(const Gallery& gallery, const GallerySources& sources, const std::string& path);

}  // namespace stepwire::gallery
