#include "engine/figure/mark_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/figure/picture.hpp"

namespace stepwire {
namespace {

// Sizes in pixels of the picture, with its font of 13 pixels.
constexpr double letter = 8.5, line = 15.0, gap = 6.0, dot = 5.0;

struct Point {
  double x = 0.0, y = 0.0;
};

/// A rectangle in pixels about its middle.
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

/// Points of the plane in pixels from the lower left corner of the axes.
class Pixels {
 public:
  Pixels(const Script& script, const PlotArea& area) : script_(script), area_(area) {}

  Point of(double x, double y) const {
    const Panel& panel = script_.panel();
    return {area_.width * share(script_.x, x, panel.log_x), area_.height * share(script_.y, y, panel.log_y)};
  }

 private:
  static double share(const Extent& extent, double value, bool logarithmic) {
    if (logarithmic && extent.low > 0.0)
      return std::log(value / extent.low) / std::log(extent.high / extent.low);
    return (value - extent.low) / (extent.high - extent.low);
  }

  const Script& script_;
  PlotArea area_;
};

/// Does the line between two points come into the box? (Liang and Barsky: what is left of the line between
/// the edges of the box, one after the other.)
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

/// Where a name may stand beside its point: right and left of it, above and below, and aslant.
constexpr std::array<Point, 8> sides{
    {{1.0, 1.0}, {-1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}, {1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}};

class Placing {
 public:
  Placing(const Panel& panel, const PlotArea& area, const Script& script)
      : panel_(panel), area_(area), script_(script), pixels_(script, area) {}

  /// The side where the name of a mark covers least.
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

  /// How much lies under a name: other marks and the frame weigh more than any curve.
  double covered(const Box& box) const {
    constexpr double heavy = 1e6;
    double weight = 0.0;
    for (const Box& name : names_) weight += box.overlaps(name) ? heavy : 0.0;
    for (const MarkedPoint& mark : panel_.marks)
      weight += box.overlaps({pixels_.of(mark.x, mark.y), dot, dot}) ? heavy : 0.0;
    const bool inside = box.middle.x > box.half_width && box.middle.x < area_.width - box.half_width &&
                        box.middle.y > box.half_height && box.middle.y < area_.height - box.half_height;
    if (!inside) weight += heavy;
    for (const Curve& curve : script_.drawn()) weight += covered(box, curve);
    return weight;
  }

  /// Rows of a curve that lie in the box or lead into it.
  double covered(const Box& box, const Curve& curve) const {
    double weight = 0.0;
    for (std::size_t i = 0; i < curve.size() && curve.columns.size() > 1; ++i) {
      const Point here = pixels_.of(curve.columns[0][i], curve.columns[1][i]);
      const Point before = i == 0 ? here : pixels_.of(curve.columns[0][i - 1], curve.columns[1][i - 1]);
      weight += meets(box, before, here) ? 1.0 : 0.0;
    }
    return weight;
  }

  const Panel& panel_;
  PlotArea area_;
  const Script& script_;
  Pixels pixels_;
  std::vector<Box> names_;
};

/// Words of gnuplot for where a label stands from its point.
std::string placed(const Point& side) {
  const char* align = side.x > 0.0 ? "left" : side.x < 0.0 ? "right" : "center";
  return fmt::format("{} offset {:.2g},{:.2g}", align, 0.7 * side.x,
                     side.x == 0.0 ? 0.9 * side.y : 0.6 * side.y);
}

}  // namespace

void cover_marks(const Panel& panel, Script& script) {
  for (const auto* points : {&panel.marks, &panel.texts})
    for (const MarkedPoint& point : *points) {
      script.x.add(point.x);
      script.y.add(point.y);
    }
}

void draw_texts(const Panel& panel, Script& script) {
  for (const MarkedPoint& text : panel.texts)
    script.set(fmt::format("set label {} at {:.9g},{:.9g} center front textcolor rgb '{}' font ',13'",
                           quoted(text.name), text.x, text.y, rimmed_text));
}

void draw_marks(const Panel& panel, const PlotArea& area, Script& script) {
  if (script.x.empty() || script.y.empty()) return;
  Placing placing(panel, area, script);
  for (const MarkedPoint& mark : panel.marks) {
    const std::string at = fmt::format("at {:.9g},{:.9g}", mark.x, mark.y);
    for (const char* look : {"ps 0.75 lc rgb '#ffffff'", "ps 0.5 lc rgb '#111111'"})
      script.set(fmt::format("set label '' {} front point pt 7 {}", at, look));
    script.set(fmt::format("set label {} {} {} front textcolor rgb '{}' font ',14'", quoted(mark.name), at,
                           placed(placing.side(mark)), rimmed_text));
  }
}

}  // namespace stepwire
