#pragma once

#include <map>
#include <string>

#include "engine/view/gallery/gallery.hpp"
#include "engine/view/gallery/gallery_html.hpp"
#include "engine/view/plot/figure.hpp"

namespace stepwire::gallery {

/// Returns the description of a figure: "force [N] over position [mm]; the block diagram".
std::string described(const plot::Figure& figure);

/// Reads from an SVG text its size, its title, which precedes all other texts, and whether it is legible on
/// dark pages. It is if it has colours for them, or no white background.
void read_picture(GalleryPicture& picture, const std::string& svg);

/// Returns texts of pictures by their names as a script, because a page that was opened as a file cannot read
/// them in any other way. The script contains JSON, compressed by gzip, in base64.
std::string picture_script(const std::map<std::string, std::string>& pictures);

/// Returns the pictures of an entry that the source has, or with `own` a section of those that it does not
/// have.
Html pictures_of(const GalleryEntry& entry, bool own);

}  // namespace stepwire::gallery
