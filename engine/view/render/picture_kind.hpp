#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stepwire::render {

/// File format of a picture. All are converted from its SVG.
enum class PictureKind { svg, png, pdf };
using PictureKinds = std::vector<PictureKind>;

/// Default of calls that name no kinds.
inline const PictureKinds usual_pictures{PictureKind::svg};

/// Returns a kind by its name; std::nullopt for any other word.
std::optional<PictureKind> picture_kind(const std::string& name);
/// Returns the kind by the ending of a file; SVG where `file` is empty. Throws yaml::Error for any other
/// ending, so that no file gets the bytes of another format.
PictureKind picture_kind_of(const std::string& file);
/// Returns "svg, png, pdf".
std::string picture_kind_names();
/// Returns ".png".
std::string ending_of(PictureKind kind);

/// Returns a picture in a format, the same bytes each time. A PNG is `width` pixels wide; with 0, twice the
/// size of the SVG, for screens and print. Throws EnvironmentError if rsvg-convert is missing or fails.
std::string converted(const std::string& svg, PictureKind kind, int width = 0);

/// Returns "rsvg-convert is not installed; ..." if it is missing; else an empty text.
std::string converter_problem();
/// Throws EnvironmentError if these kinds need rsvg-convert and it is missing.
void require_converter(const PictureKinds& kinds);

}  // namespace stepwire::render
