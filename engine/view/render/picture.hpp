#pragma once

#include <string>

namespace stepwire::render {

/// The gnuplot commands that give all pictures one look. Lines may begin and end beyond the frame.
std::string picture_style();

/// The gnuplot command that starts a picture of so many pixels.
std::string picture_terminal(double width, double height);

/// The colour by which a finished picture knows texts that lie on curves.
constexpr const char* rimmed_text = "#101010";

/// The picture that gnuplot made, with what it does not offer: a list of fonts, crisp cells of maps, white
/// rims of texts that lie on curves, a title that a screen reader says, and a look on dark screens.
std::string finished_picture(std::string svg, const std::string& title, bool has_color_scale);

}  // namespace stepwire::render
