#pragma once

#include <string>
#include <vector>

#include "engine/base/text/characters.hpp"

namespace stepwire::svg {

/// A text as it stands in SVG and HTML, in attributes as well: & < > " are replaced, control characters are
/// blanks.
std::string markup_escaped(const std::string& text);

/// On a dark screen a picture is dark: lightness is turned round and hues stay. Paper, and programs that know
/// no such rule, have it as it is.
constexpr const char* dark_style =
    "<style>@media screen and (prefers-color-scheme: dark){:root{filter:invert(.9) "
    "hue-rotate(180deg)}}</style>";
/// A picture with a scale of colours keeps them, since dark and light have a meaning there; it is dimmed
/// alone.
constexpr const char* dimmed_style =
    "<style>@media screen and (prefers-color-scheme: dark){:root{filter:brightness(.85)}}</style>";

/// A number of an attribute: two decimals [px], no zeros at its end.
std::string svg_number(double value);

/// An attribute of an element, with its value.
struct SvgAttribute {
  std::string name;
  std::string value;
  bool smooth = false;  ///< in an animation it goes evenly from frame to frame; else it jumps
};

/// An element of a picture: its attributes, and behind them text or further elements.
struct SvgElement {
  std::string name;
  std::vector<SvgAttribute> attributes{};
  std::string text{};
  std::vector<SvgElement> children{};

  SvgElement& set(std::string attribute, std::string value);
  SvgElement& set(std::string attribute, double value);
  /// A number that an animation changes evenly.
  SvgElement& move(std::string attribute, double value);
  SvgElement& add(SvgElement child);
};

/// The element as text. An attribute without a value is left out.
std::string svg_text(const SvgElement& element);

/// One picture out of several that differ only in values of attributes: it shows the first, and goes through
/// them all within `seconds`, the last included, again and again. Nothing but SVG's own animation is used.
/// Throws std::invalid_argument where the pictures differ otherwise, or are fewer than two.
std::string animated_svg(const std::vector<SvgElement>& frames, double seconds);

}  // namespace stepwire::svg
