#include "engine/view/plot/ticks.hpp"

#include <algorithm>
#include <cmath>

#include "engine/analyse/query/number.hpp"
#include "engine/view/geometry/curve.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::plot {
namespace {

constexpr double letters = 13.0, label_gap = 8.0, label_line = 17.0;  // [px]

/// Returns the usual distance of ticks: that of gnuplot's `quantize_normal_tics` for a guide of 20.
double usual_step(double width) {
  const double power = std::pow(10.0, std::floor(std::log10(width))), positions = 20.0 / (width / power);
  return power * (positions > 10.0 ? 0.2 : positions > 4.0 ? 0.5 : positions > 2.0 ? 1.0 : 2.0);
}

/// Returns the next number of the sequence 1, 2, 5, 10, ...
double next_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step) + 1e-9)), share = step / power;
  return power * (share < 1.5 ? 2.0 : share < 3.5 ? 5.0 : 10.0);
}

/// Returns the smallest distance between adjacent labels, from the widest one of an axis.
double widest_label(const geometry::Extent& shown, double step) {
  double widest = 0.0;
  for (double tick = std::ceil(shown.low / step); tick * step <= shown.high; ++tick)
    widest = std::max(widest, svg::text_width(query::short_number(tick * step, 6)));
  return letters * widest + label_gap;
}

void set_step(PlotAxis& axis, double pixels, bool level) {
  if (!axis.range || axis.log || axis.step || !axis.named_ticks.empty()) return;
  const geometry::Extent shown{(*axis.range)[0], (*axis.range)[1]};
  if (!(shown.width() > 0.0) || !std::isfinite(shown.width()) || pixels <= 0.0) return;
  double step = usual_step(shown.width());
  const auto touches = [&] {
    return step / shown.width() * pixels < (level ? widest_label(shown, step) : label_line);
  };
  while (step < shown.width() && touches()) step = next_step(step);
  axis.step = step;
}

std::ptrdiff_t letter_count(std::string_view text) {
  return std::ranges::count_if(text, [](char byte) { return (byte & 0xc0) != 0x80; });  // UTF-8
}

/// Returns the width of a legend beside the axes, for which gnuplot counts letters.
double legend_width(const PlotSpec& plot) {
  constexpr double of_letter = 0.6 * letters, beside_text = 62.0;  // [px]
  std::ptrdiff_t longest = 0;
  for (const PlotMark& mark : plot.marks)
    std::visit(
        [&](const auto& of) {
          if constexpr (requires { of.legend; }) longest = std::max(longest, letter_count(of.legend));
        },
        mark);
  return beside_text + of_letter * static_cast<double>(longest);
}

}  // namespace

AxesSize axes_size(const PlotSpec& plot, double width, double height) {
  if (plot.view) return {0.4 * width, 0.4 * height};
  const double beside = plot.color ? 95.0 : 20.0,
               legend = plot.legend == PlotSpec::Legend::beside ? legend_width(plot) : 0.0;
  const double above =
      (plot.title.empty() ? 8.0 : 28.0) + (plot.legend == PlotSpec::Legend::none ? 0.0 : 24.0);
  AxesSize size{width - 75.0 - beside - legend, height - 50.0 - above};
  if (!plot.equal || !plot.x.range || !plot.y.range) return size;
  const double x = (*plot.x.range)[1] - (*plot.x.range)[0], y = (*plot.y.range)[1] - (*plot.y.range)[0];
  const double scale = std::min(size.across / x, size.up / y);
  return {scale * x, scale * y};
}

void set_steps(PlotSpec& plot, const AxesSize& size) {
  set_step(plot.x, size.across, true);
  set_step(plot.y, plot.view ? size.across : size.up, plot.view.has_value());
  for (std::optional<PlotAxis>* axis : {&plot.z, &plot.color})
    if (*axis) set_step(**axis, size.up, false);
}

}  // namespace stepwire::plot
