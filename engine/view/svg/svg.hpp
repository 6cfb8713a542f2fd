#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/text/characters.hpp"

namespace stepwire::svg {

/// Escapes a text for SVG and HTML, also for attributes: & < > " are replaced, control characters become
/// blanks.
std::string markup_escaped(const std::string& text);

/// Style for dark screens: inverts lightness and keeps hues. On paper, and in programs without this rule, the
/// picture is unchanged.
constexpr const char* dark_style =
    "<style>@media screen and (prefers-color-scheme: dark){:root{filter:invert(.9) "
    "hue-rotate(180deg)}}</style>";
/// Style for dark screens of a picture with a colour scale, whose dark and light have a meaning. The picture
/// is only dimmed.
constexpr const char* dimmed_style =
    "<style>@media screen and (prefers-color-scheme: dark){:root{filter:brightness(.85)}}</style>";

/// Returns a number of an attribute: two decimals [px], without trailing zeros.
std::string svg_number(double value);

/// Attribute of an element, with its value.
struct SvgAttribute {
  std::string name;
  std::string value;
  bool smooth = false;  ///< true if an animation interpolates it between frames; else it jumps
};

/// Element of a picture: its attributes, followed by text or further elements.
struct SvgElement {
  std::string name;
  std::vector<SvgAttribute> attributes{};
  std::string text{};
  std::vector<SvgElement> children{};

  SvgElement& set(std::string attribute, std::string value);
  SvgElement& set(std::string attribute, double value);
  /// Sets a number that an animation interpolates.
  SvgElement& move(std::string attribute, double value);
  SvgElement& add(SvgElement child);
};

/// Returns the element as text. Attributes without a value are omitted.
std::string svg_text(const SvgElement& element);

/// Returns one picture that plays several ones, which may differ only in values of attributes, within
/// `seconds`, in a loop. Uses only SVG's own animation, and begins with the first picture. Throws
/// std::invalid_argument if the pictures differ otherwise, or are fewer than two.
std::string animated_svg(const std::vector<SvgElement>& frames, double seconds);

/// Returns the width of a text in units of the font size, for the widest of the usual sans-serif fonts
/// (DejaVu Sans). It is narrower in Helvetica, Arial or Liberation Sans.
double text_width(std::string_view text);

/// Returns the preferred font size, reduced if needed so that the text fits into `room`.
double fitted_size(std::string_view text, double wanted, double room);

}  // namespace stepwire::svg
