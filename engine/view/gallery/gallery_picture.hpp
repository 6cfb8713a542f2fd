#pragma once

#include <map>
#include <string>

#include "engine/view/gallery/gallery.hpp"
#include "engine/view/gallery/gallery_html.hpp"
#include "engine/view/plot/figure.hpp"

namespace stepwire::gallery {

/// What a figure shows, in words: "force [N] over position [mm]; the block diagram".
std::string described(const plot::Figure& figure);

/// Takes from its SVG text its size and its title, which stands ahead of the other words, and whether it
/// suits dark pages: it brings colours for them, or has no white ground.
void read_picture(GalleryPicture& picture, const std::string& svg);

/// Texts of pictures by their names, as a script: a page that was opened as a file may read them in no other
/// way. They are JSON, packed by gzip, in base64.
std::string picture_script(const std::map<std::string, std::string>& pictures);

/// The pictures of an entry that the source has, or in a section of their own those that it has not.
Html pictures_of(const GalleryEntry& entry, bool own);

}  // namespace stepwire::gallery
