#pragma once

#include <string>

#include "engine/view/plot/plot_spec.hpp"
#include "engine/view/render/picture_kind.hpp"

namespace stepwire::render {

/// Draws a figure into FOLDER/NAME.svg, or files of other kinds, and writes its spec to FOLDER/NAME.json, or
/// to another name if that is taken. Throws EnvironmentError.
void write_figure(const std::string& folder, const std::string& name, const plot::FigureSpec& figure,
                  const std::string& json_name = {}, const PictureKinds& kinds = usual_pictures);

}  // namespace stepwire::render
