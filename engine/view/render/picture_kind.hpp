#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stepwire::render {

/// Kinds of files for a picture. All come from its SVG.
enum class PictureKind { svg, png, pdf };
using PictureKinds = std::vector<PictureKind>;

/// Those that a call has which names none.
inline const PictureKinds usual_pictures{PictureKind::svg};

/// A kind by its name; nothing for another word.
std::optional<PictureKind> picture_kind(const std::string& name);
/// "svg, png, pdf".
std::string picture_kind_names();
/// ".png".
std::string ending_of(PictureKind kind);

/// A picture as such a file, the same bytes each time. A PNG has so many pixels in its width; with 0, two for
/// each of the SVG's, for screens and print. Throws EnvironmentError where rsvg-convert is missing or fails.
std::string converted(const std::string& svg, PictureKind kind, int width = 0);

/// "rsvg-convert is not installed; ..." where that is so; else empty.
std::string converter_problem();
/// Throws EnvironmentError where these kinds need rsvg-convert and it is missing.
void require_converter(const PictureKinds& kinds);

}  // namespace stepwire::render
