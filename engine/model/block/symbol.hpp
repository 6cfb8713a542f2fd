#pragma once

#include <string>

namespace stepwire {

/// How a block looks in a drawing: an outline, and in it a text or a curve. Where a declaration gives
/// neither, the drawing writes the type's name.
struct Symbol {
  enum class Outline {
    box,
    triangle,  ///< points to where the signal goes
    circle,    ///< a point where signals are added
    bar        ///< thick: signals joined or taken apart
  };

  /// `{name}` is that parameter as the file gives it, `{name|else}` the word behind the bar where that would
  /// be too long, `{name:s}` the polynomial in s whose coefficients it holds, highest power first. A " / " is
  /// a fraction bar, and in a fraction numbers stand in SI without unit. A line break starts a second line.
  std::string text{};
  /// Path data as in SVG (M, L, H, V, C, Z) in the square from -1 to 1, but with y upwards.
  std::string curve{};
  bool axes = false;  ///< the curve is the output over the input: thin axes stand behind it
  Outline outline = Outline::box;
  std::string signs{};  ///< the parameter that holds a sign for each input
};

}  // namespace stepwire
