#include <cmath>

#include "engine/view/geometry/thinning.hpp"
#include "engine/view/plot/overlay.hpp"
#include "engine/view/plot/overlay_drawing.hpp"

namespace stepwire::plot {
namespace {

std::vector<geometry::Curve> curves_of(const Motion& motion, std::span<const record::Recording> recordings) {
  return overlay_rows(motion.where, recordings[motion.recording], {&motion.x, &motion.y});
}

double length_to(const geometry::Curve& curve, std::size_t row) {
  return std::hypot(curve.columns[0][row] - curve.columns[0][row - 1],
                    curve.columns[1][row] - curve.columns[1][row - 1]);
}

double length_of(const geometry::Curve& curve) {
  double length = 0.0;
  for (std::size_t row = 1; row < curve.size(); ++row) length += length_to(curve, row);
  return length;
}

/// Adds arrow heads at equal distances, each at the end of a small step to its place.
void add_heads(const geometry::Curve& curve, double count, VectorsMark& heads) {
  const double distance = length_of(curve) / count, tail = 1e-3 * distance;
  double gone = 0.0, next = 0.5 * distance;
  for (std::size_t row = 1; row < curve.size(); ++row) {
    const double step = length_to(curve, row);
    const auto way = [&](std::size_t i) {
      return (curve.columns[i][row] - curve.columns[i][row - 1]) / step;
    };
    for (; step > 0.0 && next <= gone + step; next += distance) {
      heads.x.push_back(curve.columns[0][row - 1] + (next - gone) * way(0));
      heads.y.push_back(curve.columns[1][row - 1] + (next - gone) * way(1));
      heads.dx.push_back(tail * way(0));
      heads.dy.push_back(tail * way(1));
    }
    gone += step;
  }
}

}  // namespace

void cover_motions(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  for (const Motion& motion : panel.motions) plot.cover(curves_of(motion, recordings));
}

void draw_motions(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  for (const Motion& motion : panel.motions) {
    std::vector<geometry::Curve> lines;
    VectorsMark heads{
        .line = {motion.color, 2.0}, .pivot = 1.0, .head = 0.013, .head_angle = 22.0, .fixed_heads = true};
    for (const geometry::Curve& curve : curves_of(motion, recordings)) {
      if (motion.heads > 0.0) add_heads(curve, motion.heads, heads);
      lines.push_back(geometry::simplify(curve, {plot.x.width(), plot.y.width()}, geometry::unseen, false));
    }
    if (lines.empty()) continue;
    // a later call of add_below() draws deeper
    if (!heads.x.empty()) plot.add_below(std::move(heads));
    plot.add_below(LineMark{plane_rows(lines), {motion.color, 2.0}});
  }
}

}  // namespace stepwire::plot
