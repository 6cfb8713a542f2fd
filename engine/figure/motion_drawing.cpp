#include "engine/figure/motion_drawing.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/figure/overlay.hpp"
#include "engine/figure/thinning.hpp"

namespace stepwire {
namespace {

std::vector<Curve> curves_of(const Motion& motion, std::span<const Recording> recordings) {
  return overlay_rows(motion.where, recordings[motion.recording], {&motion.x, &motion.y});
}

double length_to(const Curve& curve, std::size_t row) {
  return std::hypot(curve.columns[0][row] - curve.columns[0][row - 1],
                    curve.columns[1][row] - curve.columns[1][row - 1]);
}

double length_of(const Curve& curve) {
  double length = 0.0;
  for (std::size_t row = 1; row < curve.size(); ++row) length += length_to(curve, row);
  return length;
}

/// Where the heads are and which way they point: x, y and a small step back from there.
Curve heads_of(const Curve& curve, double count) {
  const double distance = length_of(curve) / count, tail = 1e-3 * distance;
  Curve heads{std::vector<std::vector<double>>(4), 0};
  double gone = 0.0, next = 0.5 * distance;
  for (std::size_t row = 1; row < curve.size(); ++row) {
    const double step = length_to(curve, row);
    for (; step > 0.0 && next <= gone + step; next += distance)
      for (std::size_t i = 0; i < 2; ++i) {
        const double from = curve.columns[i][row - 1], way = (curve.columns[i][row] - from) / step;
        heads.columns[i].push_back(from + (next - gone) * way);
        heads.columns[i + 2].push_back(tail * way);
      }
    gone += step;
  }
  return heads;
}

}  // namespace

void cover_motions(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  for (const Motion& motion : panel.motions) script.cover(curves_of(motion, recordings));
}

void draw_motions(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  for (const Motion& motion : panel.motions) {
    std::vector<Curve> lines, heads;
    for (const Curve& curve : curves_of(motion, recordings)) {
      if (motion.heads > 0.0) heads.push_back(heads_of(curve, motion.heads));
      const std::vector<double> widths{script.x.high - script.x.low, script.y.high - script.y.low};
      lines.push_back(simplify(curve, widths, unseen, false));
    }
    if (lines.empty()) continue;
    // what is drawn below later lies deeper
    if (!heads.empty())
      script.plot_below(fmt::format(
          "{} using ($1-$3):($2-$4):3:4 with vectors head filled size screen 0.013,22,70 fixed lw 2 "
          "lc rgb '{}'",
          script.data(heads), motion.color));
    script.plot_below(
        fmt::format("{} using 1:2 with lines lw 2 lc rgb '{}'", script.data(lines), motion.color));
  }
}

}  // namespace stepwire
