#include <algorithm>
#include <array>
#include <cmath>

#include "engine/view/plot/overlay_drawing.hpp"

namespace stepwire::plot {
namespace {

// Sizes in pixels of the picture, with its font of 13 pixels.
constexpr double letter = 8.5, line = 15.0, gap = 6.0, dot = 5.0;

struct Point {
  double x = 0.0, y = 0.0;
};

/// Rectangle in pixels about its centre.
struct Box {
  Point middle;
  double half_width = 0.0, half_height = 0.0;

  bool holds(const Point& point) const {
    return std::abs(point.x - middle.x) <= half_width && std::abs(point.y - middle.y) <= half_height;
  }
  bool overlaps(const Box& other) const {
    return std::abs(other.middle.x - middle.x) < half_width + other.half_width &&
           std::abs(other.middle.y - middle.y) < half_height + other.half_height;
  }
};

/// Size of the axes in pixels; coordinates are from their lower left corner.
struct PlotArea {
  double width = 0.0, height = 0.0;
};

/// Conversion of points of the plane to pixels.
class Pixels {
 public:
  Pixels(const PlotBuilder& plot, const PlotArea& area) : plot_(plot), area_(area) {}

  Point of(double x, double y) const {
    const Panel& panel = plot_.panel();
    return {area_.width * share(plot_.x, x, panel.x.log), area_.height * share(plot_.y, y, panel.y.log)};
  }

 private:
  static double share(const geometry::Extent& extent, double value, bool logarithmic) {
    if (logarithmic && extent.low > 0.0)
      return std::log(value / extent.low) / std::log(extent.high / extent.low);
    return (value - extent.low) / extent.width();
  }

  const PlotBuilder& plot_;
  PlotArea area_;
};

/// Returns the lines along which a mark covers the plane.
std::vector<MarkRows> ways_of(const PlotMark& mark) {
  if (const auto* line = std::get_if<LineMark>(&mark)) return line->curves;
  if (const auto* band = std::get_if<BandMark>(&mark)) return {{band->x, band->low, {}, {}}};
  if (const auto* area = std::get_if<AreaMark>(&mark)) return {{area->x, area->y, {}, {}}};
  if (const auto* points = std::get_if<PointsMark>(&mark)) return {points->rows};
  if (const auto* vectors = std::get_if<VectorsMark>(&mark)) return {{vectors->x, vectors->y, {}, {}}};
  return {};
}

/// True if the line between two points meets the box (Liang and Barsky: the line is clipped at the edges one
/// after the other).
bool meets(const Box& box, const Point& from, const Point& to) {
  double enter = 0.0, leave = 1.0;
  const auto cut = [&](double start, double along, double half) {
    if (along == 0.0) return std::abs(start) <= half;
    const double a = (-half - start) / along, b = (half - start) / along;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
    return enter <= leave;
  };
  return cut(from.x - box.middle.x, to.x - from.x, box.half_width) &&
         cut(from.y - box.middle.y, to.y - from.y, box.half_height);
}

/// Positions of a name beside its point: diagonal, right and left, above and below.
constexpr std::array<Point, 8> sides{
    {{1.0, 1.0}, {-1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}, {1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}};

class Placing {
 public:
  Placing(const Panel& panel, const PlotArea& area, const PlotBuilder& plot)
      : panel_(panel), area_(area), pixels_(plot, area) {
    for (const PlotMark& mark : plot.spec.marks) std::ranges::move(ways_of(mark), std::back_inserter(ways_));
  }

  /// Returns the position at which the name of a mark covers least.
  Point side(const MarkedPoint& mark) {
    const auto best =
        std::ranges::min_element(sides, {}, [&](const Point& side) { return covered(name_box(mark, side)); });
    names_.push_back(name_box(mark, *best));
    return *best;
  }

 private:
  Box name_box(const MarkedPoint& mark, const Point& side) const {
    const double half = 0.5 * letter * letters(mark.name);
    const Point at = pixels_.of(mark.x, mark.y);
    return {{at.x + side.x * (gap + half), at.y + side.y * (side.x == 0.0 ? gap + 0.5 * line : 0.7 * line)},
            half,
            0.5 * line};
  }

  static double letters(const std::string& text) {
    return static_cast<double>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
  }

  /// Returns the weight of everything under a name: other marks and the frame weigh more than any curve.
  double covered(const Box& box) const {
    constexpr double heavy = 1e6;
    double weight = 0.0;
    for (const Box& name : names_) weight += box.overlaps(name) ? heavy : 0.0;
    for (const MarkedPoint& mark : panel_.marks)
      weight += box.overlaps({pixels_.of(mark.x, mark.y), dot, dot}) ? heavy : 0.0;
    const bool inside = box.middle.x > box.half_width && box.middle.x < area_.width - box.half_width &&
                        box.middle.y > box.half_height && box.middle.y < area_.height - box.half_height;
    if (!inside) weight += heavy;
    for (const MarkRows& way : ways_) weight += covered(box, way);
    return weight;
  }

  /// Returns the weight of the rows of a line that are in the box or lead into it.
  double covered(const Box& box, const MarkRows& way) const {
    double weight = 0.0;
    for (std::size_t i = 0; i < way.x.size(); ++i) {
      const Point here = pixels_.of(way.x[i], way.y[i]);
      const Point before = i == 0 ? here : pixels_.of(way.x[i - 1], way.y[i - 1]);
      weight += meets(box, before, here) ? 1.0 : 0.0;
    }
    return weight;
  }

  const Panel& panel_;
  PlotArea area_;
  Pixels pixels_;
  std::vector<MarkRows> ways_;
  std::vector<Box> names_;
};

/// Returns the name of a mark at that position of its point.
TextMark name_at(const MarkedPoint& mark, const Point& side) {
  using Align = TextMark::Align;
  return {.text = mark.name,
          .x = mark.x,
          .y = mark.y,
          .align = side.x > 0.0   ? Align::left
                   : side.x < 0.0 ? Align::right
                                  : Align::center,
          .offset = {0.7 * side.x, side.x == 0.0 ? 0.9 * side.y : 0.6 * side.y},
          .size = 14.0,
          .color = "#101010",
          .rim = true};
}

}  // namespace

void cover_marks(const Panel& panel, PlotBuilder& plot) {
  for (const auto* points : {&panel.marks, &panel.texts})
    for (const MarkedPoint& point : *points) {
      plot.x.add(point.x);
      plot.y.add(point.y);
    }
}

void draw_texts(const Panel& panel, PlotBuilder& plot) {
  for (const MarkedPoint& text : panel.texts)
    plot.spec.texts.push_back({.text = text.name, .x = text.x, .y = text.y, .color = "#101010", .rim = true});
}

void draw_marks(const Panel& panel, double width, double height, PlotBuilder& plot) {
  if (panel.marks.empty() || plot.x.empty() || plot.y.empty()) return;
  Placing placing(panel, {width, height}, plot);
  for (const MarkedPoint& mark : panel.marks) {
    plot.spec.texts.push_back({.x = mark.x, .y = mark.y, .color = "#ffffff", .dot = 7.3125});
    plot.spec.texts.push_back({.x = mark.x, .y = mark.y, .dot = 4.875});
    plot.spec.texts.push_back(name_at(mark, placing.side(mark)));
  }
}

}  // namespace stepwire::plot
