#pragma once

#include <string>

namespace stepwire::render {

/// Returns the text of a label as SVG with subscripts: "force F_e [N]" has a small e. A quantity is one or
/// two capitals and an index of one to three letters or digits, not adjacent to a letter, digit, dot or
/// underscore.
std::string with_subscripts(const std::string& label);

/// Sets the subscripts of all texts in a picture of gnuplot.
void set_subscripts(std::string& svg);

/// Returns the gnuplot commands for the common style of all pictures. Lines may begin and end beyond the
/// frame.
std::string picture_style();

/// Returns the gnuplot command that starts a picture of this size [px].
std::string picture_terminal(double width, double height);

/// Colour that identifies texts on curves in a picture, for finished_picture().
constexpr const char* rimmed_text = "#101010";

/// Completes gnuplot's picture with features that gnuplot does not have. These are a list of fonts, crisp
/// cells of maps, white outlines of texts on curves, a title for screen readers, and colours for dark
/// screens.
std::string finished_picture(std::string svg, const std::string& title, bool has_color_scale);

}  // namespace stepwire::render
