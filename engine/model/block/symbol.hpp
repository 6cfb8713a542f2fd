#pragma once

#include <string>

namespace stepwire {

/// Symbol of a block in a drawing: an outline with a text or a curve. Without either the drawing shows the
/// type's name.
struct Symbol {
  enum class Outline {
    box,
    triangle,  ///< points in the direction of the signal
    circle,    ///< a summing junction
    bar        ///< thick line: signals are joined or split
  };

  /// Text with placeholders. `{name}` is a parameter as written in the file, `{name|else}` the word `else`
  /// where that is too long. `{name:s}` is the polynomial in s with these coefficients, highest power first.
  /// A " / " is a fraction bar; numbers in a fraction are in SI without unit. A line break starts a second
  /// line.
  std::string text{};
  /// Path data as in SVG (M, L, H, V, C, Z) in the square from -1 to 1, but with y upwards.
  std::string curve{};
  bool axes = false;  ///< the curve is output over input: thin axes are drawn behind it
  Outline outline = Outline::box;
  std::string signs{};  ///< parameter that holds a sign for each input
};

}  // namespace stepwire
