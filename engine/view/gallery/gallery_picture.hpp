#pragma once

#include <map>
#include <string>

#include "engine/view/gallery/gallery.hpp"
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

/// Returns the page of one picture of an entry as SVG: the picture, and below it the number and the caption
/// of the figure. `svg` is the text of the picture.
std::string printed_page(const GalleryEntry& entry, const GalleryPicture& picture, const std::string& svg);

/// Returns the name of an entry in a list of pages: "Figure 15: The force over a 1-D map".
std::string printed_name(const GalleryEntry& entry);

}  // namespace stepwire::gallery
