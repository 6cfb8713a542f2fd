#include "engine/figure/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/number.hpp"
#include "engine/figure/svg.hpp"
#include "engine/figure/text_width.hpp"

namespace stepwire {
namespace {

constexpr double letters = 13.0, label_gap = 8.0, label_line = 17.0;  // [px]

/// The distance of ticks that gnuplot takes: its `quantize_normal_tics` for a guide of 20.
double usual_step(double width) {
  const double power = std::pow(10.0, std::floor(std::log10(width))), positions = 20.0 / (width / power);
  return power * (positions > 10.0 ? 0.2 : positions > 4.0 ? 0.5 : positions > 2.0 ? 1.0 : 2.0);
}

/// 1, 2, 5, 10, ...: the next one.
double next_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step) + 1e-9)), share = step / power;
  return power * (share < 1.5 ? 2.0 : share < 3.5 ? 5.0 : 10.0);
}

/// How far apart two labels beside each other must be, for the widest of an axis.
double widest_label(const Extent& shown, double step) {
  double widest = 0.0;
  for (double tick = std::ceil(shown.low / step); tick * step <= shown.high; ++tick)
    widest = std::max(widest, text_width(short_number(tick * step, 6)));
  return letters * widest + label_gap;
}

std::string command(const std::string& axis, const Extent& shown, double pixels, bool level) {
  const double width = shown.high - shown.low;
  if (!(width > 0.0) || !std::isfinite(width) || pixels <= 0.0) return {};
  const double usual = usual_step(width);
  double step = usual;
  const auto touches = [&] {
    return step / width * pixels < (level ? widest_label(shown, step) : label_line);
  };
  while (step < width && touches()) step = next_step(step);
  return step == usual ? std::string() : fmt::format("set {}tics {:.9g}\n", axis, step);
}

/// The blank next to the middle; npos where there is none.
std::size_t middle_blank(const std::string& text) {
  std::size_t best = std::string::npos;
  const auto far = [&](std::size_t at) {
    return std::abs(static_cast<double>(2 * at) - static_cast<double>(text.size()));
  };
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1))
    if (best == std::string::npos || far(at) < far(best)) best = at;
  return best;
}

/// In double quotes, in which gnuplot knows the end of a line.
std::string in_two_lines(std::string first, std::string second) {
  for (std::string* line : {&first, &second}) {
    replace_all(*line, "\\", "\\\\");
    replace_all(*line, "\"", "\\\"");
  }
  return "\"" + first + "\\n" + second + "\"";
}

}  // namespace

AxesSize axes_size(const Script& script, double width, double height) {
  const Panel& panel = script.panel();
  if (script.space) return {0.4 * width, 0.4 * height};
  const double beside = panel.find("color") ? 95.0 : 20.0, legend = script.titles() > 4 ? 150.0 : 0.0;
  const double above = (panel.words.contains("title") ? 28.0 : 8.0) + (script.titles() > 0 ? 24.0 : 0.0);
  AxesSize size{width - 75.0 - beside - legend, height - 50.0 - above};
  if (!panel.equal || script.x.empty() || script.y.empty()) return size;
  const double x = script.x.high - script.x.low, y = script.y.high - script.y.low;
  const double scale = std::min(size.across / x, size.up / y);
  return {scale * x, scale * y};
}

std::string ticks_apart(const Script& script, const AxesSize& size) {
  std::string commands;
  for (const auto& [axis, shown] : script.shown()) {
    const bool level = axis == "x" || (script.space && axis == "y");
    commands += command(axis, shown, level ? size.across : size.up, level);
  }
  return commands;
}

std::string fitted_title(const std::string& text, double room) {
  constexpr double usual = 14.0, least = 11.0;
  double size = fitted_size(text, usual, room);
  const std::size_t blank = middle_blank(text);
  std::string title = quoted(text);
  if (size < least && blank != std::string::npos) {
    const std::string first = text.substr(0, blank), second = text.substr(blank + 1);
    size = std::min(fitted_size(first, usual, room), fitted_size(second, usual, room));
    title = in_two_lines(first, second);
  }
  return size < usual ? title + fmt::format(" font ',{:.1f}'", size) : title;
}

}  // namespace stepwire
