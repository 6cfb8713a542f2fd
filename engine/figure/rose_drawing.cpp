#include "engine/figure/rose_drawing.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/figure/number.hpp"
#include "engine/figure/overlay.hpp"
#include "engine/figure/picture.hpp"
#include "engine/figure/plot_kind.hpp"

namespace stepwire {
namespace {

enum RoseColumn { point_x, point_y, spoke_angle, spoke_value };

/// A rose with its rows, and where its disc is.
struct DrawnRose {
  const Rose& rose;
  Curve rows;
  double x, y;

  Curve circle() const {
    constexpr int corners = 72;
    constexpr double turn = 6.283185307179586;
    Curve line{std::vector<std::vector<double>>(2), 0};
    for (int i = 0; i <= corners; ++i) {
      line.columns[0].push_back(x + rose.radius * std::cos(turn * i / corners));
      line.columns[1].push_back(y + rose.radius * std::sin(turn * i / corners));
    }
    return line;
  }

  /// Middle of the disc, the way to the end of a spoke, and its value.
  Curve spokes(double full) const {
    Curve spokes{std::vector<std::vector<double>>(5), 0};
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const double angle = rows.columns[spoke_angle][row], value = rows.columns[spoke_value][row];
      const double length = full > 0.0 ? rose.radius * value / full : 0.0;
      const double cells[] = {x, y, length * std::cos(angle), length * std::sin(angle), value};
      for (std::size_t i = 0; i < 5; ++i) spokes.columns[i].push_back(cells[i]);
    }
    return spokes;
  }

  /// From the point to the edge of the disc; nothing where the point lies on it.
  std::optional<Curve> leader() const {
    const double from_x = rows.columns[point_x].front(), from_y = rows.columns[point_y].front();
    const double distance = std::hypot(from_x - x, from_y - y);
    if (distance <= rose.radius) return std::nullopt;
    const double share = rose.radius / distance;
    return Curve{{{from_x, x + share * (from_x - x)}, {from_y, y + share * (from_y - y)}}, 0};
  }
};

std::vector<DrawnRose> drawn_roses(const Panel& panel, std::span<const Recording> recordings) {
  std::vector<DrawnRose> drawn;
  for (const Rose& rose : panel.roses)
    for (Curve& rows :
         overlay_rows(rose.where, recordings[rose.recording], {&rose.x, &rose.y, &rose.angle, &rose.value})) {
      const double x = rose.at ? (*rose.at)[0] : rows.columns[point_x].front();
      const double y = rose.at ? (*rose.at)[1] : rows.columns[point_y].front();
      drawn.push_back({rose, std::move(rows), x, y});
    }
  return drawn;
}

double largest_value(const std::vector<DrawnRose>& roses) {
  double largest = 0.0;
  for (const DrawnRose& one : roses)
    for (const double value : one.rows.columns[spoke_value]) largest = std::max(largest, value);
  return largest;
}

void write_names(const DrawnRose& one, double full, Script& script) {
  const std::string style = fmt::format("center front textcolor rgb '{}' font ',12'", rimmed_text);
  script.set(fmt::format("set label {} at {:.9g},{:.9g} {} offset 0,-0.8",
                         quoted(short_number(full, 3) + " " + printed_unit(one.rose.value.unit_text)), one.x,
                         one.y - one.rose.radius, style));
  if (!one.rose.name.empty())
    script.set(fmt::format("set label {} at {:.9g},{:.9g} {} offset 0,0.8", quoted(one.rose.name), one.x,
                           one.y + one.rose.radius, style));
}

void draw_leader(const Curve& leader, Script& script) {
  script.plot(script.data({leader}) + " using 1:2 with lines lw 1 lc rgb '#555555'");
  script.set(fmt::format("set label '' at {:.9g},{:.9g} front point pt 7 ps 0.4 lc rgb '#111111'",
                         leader.columns[0][0], leader.columns[1][0]));
}

void draw_rose(const DrawnRose& one, double full, Script& script) {
  const bool has_colors = script.panel().kind && script.panel().kind->channel("color");
  const std::string disc = script.data({one.circle()});
  script.plot(disc + " using 1:2 with filledcurves closed fc rgb '#ffffff' fs solid noborder");
  script.plot(disc + " using 1:2 with lines lw 1 lc rgb '#555555'");
  if (const auto leader = one.leader()) draw_leader(*leader, script);
  const std::string spokes = script.data({one.spokes(full)});
  script.plot(fmt::format("{} using 1:2:3:4{} with vectors nohead lw 1.6 lc {}", spokes,
                          has_colors ? ":5" : "", has_colors ? "palette" : "rgb '" + curve_color(0) + "'"));
  script.plot(spokes + " using ($1+$3):($2+$4) with lines lw 1.4 lc rgb '#222222'");
  write_names(one, full, script);
}

}  // namespace

void cover_roses(const Panel& panel, Script& script) {
  for (const Rose& rose : panel.roses) {
    if (!rose.at) continue;
    for (const double side : {-rose.radius, rose.radius}) {
      script.x.add((*rose.at)[0] + side);
      script.y.add((*rose.at)[1] + side);
    }
  }
}

void draw_roses(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  const std::vector<DrawnRose> roses = drawn_roses(panel, recordings);
  const double full = largest_value(roses);
  for (const DrawnRose& one : roses) draw_rose(one, full, script);
}

}  // namespace stepwire
