#pragma once

#include <array>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace stepwire::plot {

/// Member of a spec and its name in JSON.
template <class Struct, class Value>
struct SpecField {
  const char* name;
  Value Struct::*member;
};

template <class Struct, class Value>
constexpr SpecField<Struct, Value> field(const char* name, Value Struct::*member) {
  return {name, member};
}

// Marks are drawn between the axes, in their units. The fields of each are listed once, for the JSON;
// README.md of this folder documents them. Widths and sizes are in pixels, colours "#rrggbb".

/// Successive points: columns of equal length; columns that the mark does not use are empty.
struct MarkRows {
  std::vector<double> x, y, z;
  std::vector<double> value;  ///< along the colour axis

  bool operator==(const MarkRows&) const = default;
  static auto fields() {
    return std::tuple{field("x", &MarkRows::x), field("y", &MarkRows::y), field("z", &MarkRows::z),
                      field("value", &MarkRows::value)};
  }
};

struct LineStyle {
  std::string color{};  ///< empty: that of the values
  double width = 1.6;
  std::vector<double> dash{};  ///< stroke and gap in widths of the line; empty: solid

  bool operator==(const LineStyle&) const = default;
  static auto fields() {
    return std::tuple{field("color", &LineStyle::color), field("width", &LineStyle::width),
                      field("dash", &LineStyle::dash)};
  }
};

/// Lines in the plane or in space, not connected with each other.
struct LineMark {
  static constexpr const char* name = "line";
  std::vector<MarkRows> curves{};
  LineStyle line{};
  double dots = 0.0;  ///< diameter of a dot at each row; 0: none
  std::string legend{};

  static auto fields() {
    return std::tuple{field("curves", &LineMark::curves), field("line", &LineMark::line),
                      field("dots", &LineMark::dots), field("legend", &LineMark::legend)};
  }
};

/// Transparent area between two lines over x.
struct BandMark {
  static constexpr const char* name = "band";
  std::vector<double> x, low, high;
  std::string color;
  double opacity = 0.2;

  static auto fields() {
    return std::tuple{field("x", &BandMark::x), field("low", &BandMark::low), field("high", &BandMark::high),
                      field("color", &BandMark::color), field("opacity", &BandMark::opacity)};
  }
};

/// Range of x, shaded behind everything else over the full height of the frame.
struct SpanMark {
  static constexpr const char* name = "span";
  double low = 0.0, high = 0.0;
  std::string color;

  static auto fields() {
    return std::tuple{field("low", &SpanMark::low), field("high", &SpanMark::high),
                      field("color", &SpanMark::color)};
  }
};

/// Filled polygon; loops of the opposite orientation are holes.
struct AreaMark {
  static constexpr const char* name = "area";
  std::vector<double> x, y;
  std::string color;

  static auto fields() {
    return std::tuple{field("x", &AreaMark::x), field("y", &AreaMark::y), field("color", &AreaMark::color)};
  }
};

struct PointsMark {
  static constexpr const char* name = "points";
  enum class Symbol { disc, ring, asterisk };
  static constexpr std::array symbols{"disc", "ring", "asterisk"};
  MarkRows rows;
  Symbol symbol = Symbol::disc;
  double size = 4.0;    ///< diameter
  double width = 1.0;   ///< of the lines of a ring or an asterisk
  std::string color{};  ///< empty: that of the values
  std::string legend{};

  static auto fields() {
    return std::tuple{field("rows", &PointsMark::rows),   field("symbol", &PointsMark::symbol),
                      field("size", &PointsMark::size),   field("width", &PointsMark::width),
                      field("color", &PointsMark::color), field("legend", &PointsMark::legend)};
  }
};

/// Boxes of a box plot with their whiskers, one for each element.
struct BoxesMark {
  static constexpr const char* name = "boxes";
  std::vector<double> x, low_whisker, lower, upper, high_whisker;
  double width = 0.5;  ///< in units of x
  std::string color;
  std::string legend{};

  static auto fields() {
    return std::tuple{field("x", &BoxesMark::x),
                      field("low_whisker", &BoxesMark::low_whisker),
                      field("lower", &BoxesMark::lower),
                      field("upper", &BoxesMark::upper),
                      field("high_whisker", &BoxesMark::high_whisker),
                      field("width", &BoxesMark::width),
                      field("color", &BoxesMark::color),
                      field("legend", &BoxesMark::legend)};
  }
};

/// Filled rectangles: bars, bins, cells.
struct RectanglesMark {
  static constexpr const char* name = "rectangles";
  std::vector<double> x_low{}, x_high{}, y_low{}, y_high{};
  std::vector<double> value{};  ///< along the colour axis, without a colour
  std::string color{};
  std::string edge{};  ///< colour of their edges; empty: none
  std::string legend{};

  static auto fields() {
    return std::tuple{field("x_low", &RectanglesMark::x_low), field("x_high", &RectanglesMark::x_high),
                      field("y_low", &RectanglesMark::y_low), field("y_high", &RectanglesMark::y_high),
                      field("value", &RectanglesMark::value), field("color", &RectanglesMark::color),
                      field("edge", &RectanglesMark::edge),   field("legend", &RectanglesMark::legend)};
  }
};

/// Equal cells coloured by their values.
struct ImageMark {
  static constexpr const char* name = "image";
  double x = 0.0, y = 0.0;    ///< centre of the lower left cell
  double dx = 1.0, dy = 1.0;  ///< size of a cell
  std::size_t columns = 0, rows = 0;
  std::vector<double> values;  ///< row by row; NaN cells are not drawn

  static auto fields() {
    return std::tuple{field("x", &ImageMark::x),
                      field("y", &ImageMark::y),
                      field("dx", &ImageMark::dx),
                      field("dy", &ImageMark::dy),
                      field("columns", &ImageMark::columns),
                      field("rows", &ImageMark::rows),
                      field("values", &ImageMark::values)};
  }
};

/// Straight strokes, with arrow heads or without.
struct VectorsMark {
  static constexpr const char* name = "vectors";
  std::vector<double> x{}, y{}, dx{}, dy{};
  std::vector<double> value{};
  LineStyle line{};
  double pivot = 0.0;        ///< Share of a stroke behind its point.
  double head = 0.0;         ///< Length of a head as a share of the picture's width; 0: none.
  double head_angle = 20.0;  ///< Angle between its side and its stroke [degrees].
  bool fixed_heads = false;  ///< False if short strokes have smaller heads.
  std::string legend{};

  static auto fields() {
    return std::tuple{field("x", &VectorsMark::x),
                      field("y", &VectorsMark::y),
                      field("dx", &VectorsMark::dx),
                      field("dy", &VectorsMark::dy),
                      field("value", &VectorsMark::value),
                      field("line", &VectorsMark::line),
                      field("pivot", &VectorsMark::pivot),
                      field("head", &VectorsMark::head),
                      field("head_angle", &VectorsMark::head_angle),
                      field("fixed_heads", &VectorsMark::fixed_heads),
                      field("legend", &VectorsMark::legend)};
  }
};

/// Coloured surface between successive lines in space.
struct SurfaceMark {
  static constexpr const char* name = "surface";
  std::vector<MarkRows> lines;  ///< without values, z determines the colour

  static auto fields() { return std::tuple{field("lines", &SurfaceMark::lines)}; }
};

using PlotMark = std::variant<LineMark, BandMark, SpanMark, AreaMark, PointsMark, BoxesMark, RectanglesMark,
                              ImageMark, VectorsMark, SurfaceMark>;

/// Text in front of all marks, with or without a dot at its point.
struct TextMark {
  enum class Align { left, center, right };
  static constexpr std::array alignments{"left", "center", "right"};
  std::string text{};  ///< empty: only the dot
  double x = 0.0, y = 0.0;
  bool in_frame = false;  ///< true for shares of the frame, else places along the axes
  Align align = Align::center;
  std::array<double, 2> offset{};  ///< right and up, in widths and heights of a letter
  double size = 13.0;              ///< of the letters
  std::string color = "#111111";
  bool rim = false;  ///< white outline, legible on curves and colours
  double dot = 0.0;  ///< diameter; 0: none

  bool operator==(const TextMark&) const = default;
  static auto fields() {
    return std::tuple{field("text", &TextMark::text),   field("x", &TextMark::x),
                      field("y", &TextMark::y),         field("in_frame", &TextMark::in_frame),
                      field("align", &TextMark::align), field("offset", &TextMark::offset),
                      field("size", &TextMark::size),   field("color", &TextMark::color),
                      field("rim", &TextMark::rim),     field("dot", &TextMark::dot)};
  }
};

}  // namespace stepwire::plot
