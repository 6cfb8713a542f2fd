#include "engine/figure/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "engine/base/characters.hpp"
#include "engine/figure/svg.hpp"

namespace stepwire {
namespace {

std::string range_name(const std::string& axis) {
  return axis == "color" ? "cb" : axis;
}

bool is_log(const Panel& panel, const std::string& axis) {
  return (axis == "x" && panel.log_x) || (axis == "y" && panel.log_y) || (axis == "color" && panel.log_color);
}

}  // namespace

void Extent::add(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

Extent Extent::padded(double share) const {
  if (empty()) return {0.0, 1.0};
  const double width = high - low;
  const double least = 1e-9 * std::max(std::abs(low), std::abs(high));
  const double room =
      width > least ? share * width : std::max(0.05 * std::abs(low), least > 0.0 ? least : 1.0);
  return {low - room, high + room};
}

std::string Script::data(const std::vector<Curve>& curves, const char* gap) {
  if (!panel_.marks.empty()) std::ranges::copy(curves, std::back_inserter(drawn_));
  const std::string block = fmt::format("${}{}", name_, blocks_++);
  commands_ += block + " << EOD\n";
  auto out = std::back_inserter(commands_);
  for (const Curve& curve : curves) {
    for (std::size_t row = 0; row < curve.size(); ++row)
      for (std::size_t i = 0; i < curve.columns.size(); ++i)
        fmt::format_to(out, "{:.7g}{}", curve.columns[i][row], i + 1 < curve.columns.size() ? ' ' : '\n');
    // Two empty lines make gnuplot lift its pen; after one alone it ties curves in space to a net.
    if (&curve != &curves.back()) commands_ += gap;
  }
  commands_ += "EOD\n";
  return block;
}

void Script::cover(const std::vector<Curve>& curves) {
  for (const Curve& curve : curves) {
    for (const double value : curve.columns.at(0)) x.add(value);
    for (const double value : curve.columns.at(1)) y.add(value);
  }
}

void Script::plot(const std::string& item, const std::string& title, const std::string& behind) {
  items_.push_back(item + (title.empty() ? " notitle" : " title " + quoted(title)) + behind);
  if (!title.empty()) ++titles_;
}

void Script::label(const std::string& axis, const Series& series) {
  const auto word = panel_.words.find(axis + "_label");
  Series labelled = series;
  if (word != panel_.words.end()) labelled.label = word->second;
  set(fmt::format("set {}label {}", range_name(axis), quoted(labelled.axis_label())));
}

void Script::range(const std::string& axis, const Extent& extent) {
  const auto given = panel_.ranges.find(axis + "_range");
  const bool from_file = given != panel_.ranges.end();
  Extent shown = from_file ? Extent{given->second[0], given->second[1]} : extent;
  if (is_log(panel_, axis)) {
    set(fmt::format("set logscale {}", range_name(axis)));
    if (shown.low <= 0.0) return set(fmt::format("set {}range [*:*]", range_name(axis)));
  }
  set(fmt::format("set {}range [{:.9g}:{:.9g}]", range_name(axis), shown.low, shown.high));
  if (is_log(panel_, axis)) return name_more_than_decades(axis, shown);
  shown_[range_name(axis)] = shown;
}

/// On a logarithmic axis of less than two decades 2 and 5 have labels too: gnuplot names powers of ten only.
void Script::name_more_than_decades(const std::string& axis, const Extent& shown) {
  if (shown.high > 100.0 * shown.low) return;
  std::vector<std::string> labels;
  for (double decade = std::pow(10.0, std::floor(std::log10(shown.low))); decade <= shown.high;
       decade *= 10.0)
    for (const double label : {2.0 * decade, 5.0 * decade})
      if (label >= shown.low && label <= shown.high) labels.push_back(fmt::format("{:.9g}", label));
  if (!labels.empty()) set(fmt::format("set {}tics add ({})", range_name(axis), fmt::join(labels, ", ")));
}

void Script::color_bar(const Series& series, const Extent& extent) {
  const bool flat = extent.empty() || !(extent.high > extent.low);
  range("color", flat ? extent.padded(0.0) : extent);
  label("color", series);
}

void Script::plane(double room) {
  for (const std::string axis : {"x", "y"}) {
    Extent& extent = axis == "x" ? x : y;
    const auto given = panel_.ranges.find(axis + "_range");
    extent = given != panel_.ranges.end() ? Extent{given->second[0], given->second[1]} : extent.padded(room);
    range(axis, extent);
  }
}

std::string Script::text() const {
  if (items_.empty())
    return commands_ +
           "set xrange [0:1]\nset yrange [0:1]\nunset logscale\nset xtics autofreq\n"
           "set label 'no rows to draw' at graph 0.5, graph 0.5 center textcolor rgb '#555555'\nplot 2 "
           "notitle\n";
  const std::string verb = space ? "splot " : "plot ";
  return commands_ + verb + fmt::format("{}", fmt::join(items_, ", \\\n  ")) + "\n";
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : printable(text)) {
    if (c == '\'')
      result += "’";  // gnuplot takes two for one, but not at the beginning
    else
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  replace_all(result, "]]>", "]] >");  // which gnuplot would leave as it is, and XML refuses
  return result + "'";
}

std::string quoted_tic(const std::string& text) {
  std::string result = quoted(text);
  replace_all(result, "%", "%%");
  return result;
}

std::string printed_unit(const std::string& unit) {
  if (unit.empty() || unit == "1") return "–";
  std::string text = unit;
  replace_all(text, "^2", "²");
  replace_all(text, "^3", "³");
  replace_all(text, ".", "·");
  if (text == "deg") return "°";
  if (text == "um") return "µm";
  return text;
}

std::string curve_color(std::size_t index) {
  static const std::array<const char*, 8> colors{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                 "#E69F00", "#56B4E9", "#4D4D4D", "#8C6D1F"};
  return colors[index % colors.size()];
}

std::string Series::axis_label() const {
  return unit_text.empty() ? label : fmt::format("{} [{}]", label, printed_unit(unit_text));
}

}  // namespace stepwire
