#include <cmath>

#include "engine/view/geometry/grid.hpp"
#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

constexpr std::size_t strip_cells = 500;

/// Cells of the strip: the mean of all values that pass over them; NaN without any.
class Strip {
 public:
  explicit Strip(const geometry::Extent& extent)
      : low_(extent.low), step_((extent.high - extent.low) / strip_cells) {}

  /// Adds a segment between successive rows, with linear values.
  void pass(double x0, double value0, double x1, double value1) {
    const std::size_t from = cell(std::min(x0, x1)), to = cell(std::max(x0, x1));
    for (std::size_t i = from; i <= to; ++i) {
      const double x = low_ + (static_cast<double>(i) + 0.5) * step_;
      const double part = x1 == x0 ? 0.0 : std::clamp((x - x0) / (x1 - x0), 0.0, 1.0);
      sums_[i] += value0 + part * (value1 - value0);
      counts_[i] += 1.0;
    }
  }

  ImageMark image() const {
    ImageMark image{low_ + 0.5 * step_, 0.5, step_, 1.0, strip_cells, 1, {}};
    for (std::size_t i = 0; i < strip_cells; ++i)
      image.values.push_back(counts_[i] > 0.0 ? sums_[i] / counts_[i] : query::nothing);
    return image;
  }

 private:
  std::size_t cell(double x) const {
    return static_cast<std::size_t>(
        std::clamp((x - low_) / step_, 0.0, static_cast<double>(strip_cells - 1)));
  }

  double low_, step_;
  std::vector<double> sums_ = std::vector<double>(strip_cells, 0.0),
                      counts_ = std::vector<double>(strip_cells, 0.0);
};

ImageMark strip_of(const geometry::Curves& all, const geometry::Extent& extent) {
  Strip strip(extent);
  for (const geometry::Curve& curve : all.curves) {
    const auto &x = curve.columns[0], &value = curve.columns[1];
    if (curve.size() == 1) strip.pass(x[0], value[0], x[0], value[0]);
    for (std::size_t i = 1; i < curve.size(); ++i) strip.pass(x[i - 1], value[i - 1], x[i], value[i]);
  }
  return strip.image();
}

/// Returns a round step with two to five ticks on a short colour bar.
double few_steps(double width) {
  const double power = std::pow(10.0, std::floor(std::log10(0.4 * width)));
  for (const double step : {5.0, 2.0})
    if (step * power <= 0.45 * width) return step * power;
  return power;
}

void draw_strip(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const query::Series &x = *panel.find("x"), &color = *panel.find("color");
  const geometry::Curves all = gather(panel, recording_of(panel, recordings), {&x, &color});
  for (const geometry::Curve& curve : all.curves)
    for (const double value : curve.columns[0]) plot.x.add(value);
  plot.label("x", x);
  if (all.curves.empty()) return;
  plot.x = plot.x.padded(0.0);
  ImageMark strip = strip_of(all, plot.x);
  plot.y = {0.0, 1.0};
  plot.plane(0.0);
  plot.spec.x.grid = plot.spec.y.grid = plot.spec.y.line = false;
  // The label of the colour bar is beside the strip and must not be longer than its height.
  plot.height = std::clamp(70.0 + 8.0 * static_cast<double>(color.axis_label().size()), 170.0, 320.0);
  const geometry::Extent shown = geometry::extent_of(strip.values);
  plot.color_bar(color, shown);
  if (!panel.color.range && shown.high > shown.low) plot.spec.color->step = few_steps(shown.width());
  plot.add(std::move(strip));
}

}  // namespace

PlotKind strip_plot() {
  PlotKind kind{"strip",
                "a strip along x whose colour is a second quantity",
                {{"x", "along the strip", true}, {"color", "shown as colour, with a colour bar", true}},
                {},
                true,
                draw_strip};
  kind.lacks = {KeyNeeds::legend, KeyNeeds::up};
  return kind;
}

}  // namespace stepwire::plot
