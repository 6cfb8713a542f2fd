#pragma once

#include <functional>
#include <string>

#include "engine/view/gallery/gallery_html.hpp"

namespace stepwire::gallery {

/// Function that returns the address of the page of a part, by its path in the file; an empty address without
/// a page.
using PartAddress = std::function<Address(const std::string& path)>;

/// Returns a YAML text as HTML: spans of the classes key, comment, string, number, name and type, and links
/// at its parts.
Html painted_yaml(const std::string& text, const PartAddress& part);

}  // namespace stepwire::gallery
