#pragma once

#include <functional>
#include <string>

#include "engine/view/gallery/gallery_html.hpp"

namespace stepwire::gallery {

/// The address of the page of a part, by its path as the file has it; empty where there is none.
using PartAddress = std::function<Address(const std::string& path)>;

/// A YAML text as HTML in colours: spans of the classes key, comment, string, number, name and type, and
/// links at the parts that it uses.
Html painted_yaml(const std::string& text, const PartAddress& part);

}  // namespace stepwire::gallery
