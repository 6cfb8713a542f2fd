#pragma once

#include <span>
#include <string>

#include "engine/view/plot/figure.hpp"
#include "engine/view/plot/plot_spec.hpp"
#include "engine/view/render/picture_kind.hpp"

namespace stepwire::render {

/// Picture, and the warnings of the program that drew it (usually none).
struct Drawing {
  std::string svg;
  std::string warnings;
};

/// Draws exactly the content of the spec; the same spec gives the same bits. Throws EnvironmentError if
/// gnuplot or another drawing program is missing or fails.
Drawing render(const plot::FigureSpec& figure);

/// Draws a figure; the same data give the same bits. Throws EnvironmentError if gnuplot or another drawing
/// program is missing or fails.
Drawing draw(const plot::Figure& figure, std::span<const record::Recording> recordings);

/// Draws a figure into FOLDER/NAME.svg, or files of other kinds, and writes its spec to FOLDER/NAME.json, or
/// to another name if that is taken. Throws EnvironmentError.
void write_figure(const std::string& folder, const std::string& name, const plot::FigureSpec& figure,
                  const std::string& json_name = {}, const PictureKinds& kinds = usual_pictures);

}  // namespace stepwire::render
