#include "engine/view/geometry/density.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace stepwire::geometry {
namespace {

/// Rasterises curves over cells, one after the other.
class Raster {
 public:
  explicit Raster(Density& density) : density_(density), last_(density.counts.size(), 0) {}

  void add(const Curve& curve) {
    ++curve_;
    const std::vector<double>&x = curve.columns[0], &y = curve.columns[1];
    for (std::size_t i = 0; i < curve.size(); ++i)
      draw(x[i > 0 ? i - 1 : 0], y[i > 0 ? i - 1 : 0], x[i], y[i]);
  }

 private:
  /// Marks the cells along a line, in steps of half a cell.
  void draw(double x0, double y0, double x1, double y1) {
    const double across = (x1 - x0) / density_.cell_width(), up = (y1 - y0) / density_.cell_height();
    const double largest = 4.0 * static_cast<double>(density_.columns + density_.rows);
    const auto steps = static_cast<std::size_t>(
        std::clamp(std::ceil(2.0 * std::max(std::abs(across), std::abs(up))), 1.0, largest));
    for (std::size_t i = 0; i <= steps; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(steps);
      mark(x0 + share * (x1 - x0), y0 + share * (y1 - y0));
    }
  }

  void mark(double x, double y) {
    const Extent &across = density_.x, &up = density_.y;
    if (!(x >= across.low && x <= across.high && y >= up.low && y <= up.high)) return;
    const auto column = std::min(static_cast<std::size_t>((x - across.low) / density_.cell_width()),
                                 density_.columns - 1),
               row = std::min(static_cast<std::size_t>((y - up.low) / density_.cell_height()),
                              density_.rows - 1);
    const std::size_t cell = row * density_.columns + column;
    if (last_[cell] == curve_) return;
    last_[cell] = curve_;
    density_.counts[cell] += 1.0;
  }

  Density& density_;
  std::vector<std::uint32_t> last_;  ///< last curve through each cell
  std::uint32_t curve_ = 0;
};

}  // namespace

Density density_of(const std::vector<Curve>& curves, const Extent& x, const Extent& y, std::size_t columns,
                   std::size_t rows) {
  Density density{x, y, columns, rows, std::vector<double>(columns * rows, 0.0)};
  Raster raster(density);
  for (const Curve& curve : curves) raster.add(curve);
  return density;
}

}  // namespace stepwire::geometry
