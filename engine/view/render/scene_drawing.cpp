#include "engine/view/render/scene_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/query/run_rows.hpp"
#include "engine/view/geometry/curve.hpp"
#include "engine/view/geometry/thinning.hpp"

namespace stepwire::render {
namespace {

using Point = std::array<double, 2>;

constexpr double gap = 14.0, words_height = 26.0, title_height = 34.0, margin = 10.0,
                 edge = 4.0;  // [px]

const char* font = "Helvetica, Arial, sans-serif";

svg::SvgElement rectangle(double x, double y, double width, double height) {
  svg::SvgElement element{"rect"};
  return element.set("x", x).set("y", y).set("width", width).set("height", height);
}

svg::SvgElement words_at(double x, double y, double size, double room, const std::string& words,
                         const std::string& color) {
  svg::SvgElement element{"text"};
  element.set("x", x)
      .set("y", y)
      .set("font-family", font)
      .set("font-size", svg::fitted_size(words, size, room))
      .set("text-anchor", "middle");
  element.set("class", "words").set("fill", color);
  element.text = words;
  return element;
}

svg::SvgElement stop(double offset, const std::string& color, double opacity) {
  svg::SvgElement element{"stop"};
  return element.set("offset", offset).set("stop-color", color).set("stop-opacity", opacity);
}

/// Draws shapes at the scale of a frame.
class FramePen {
 public:
  FramePen(const scene::Scene& scene, svg::SvgElement& frame)
      : scene_(scene), frame_(frame), scale_(scene_width / (scene.x[1] - scene.x[0])) {}

  void draw(const scene::SceneShape& shape) {
    const std::string& kind = shape.object->kind->name;
    if (kind == "walls")
      draw_wall(shape);
    else if (kind == "rod")
      draw_rod(shape);
    else if (kind == "line")
      draw_strokes(shape, shape.points, {{1.0, 1.0, ""}});
    else if (kind == "circle")
      draw_circle(shape);
    else if (kind == "text")
      draw_text(shape);
    else
      draw_disc(shape, kind == "ball");
  }

 private:
  /// Line drawn over another one: its share of the width, its opacity, and its colour, else that of the
  /// shape.
  struct Stroke {
    double share, opacity;
    const char* color;
  };

  double x(Point at) const { return scale_ * (at[0] - scene_.x[0]); }
  double y(Point at) const { return scale_ * (scene_.y[1] - at[1]); }

  svg::SvgElement& add(svg::SvgElement element, const scene::SceneShape& shape) {
    element.set("visibility", shape.shown ? "visible" : "hidden");
    return frame_.add(std::move(element)).children.back();
  }

  static void set_stroke(svg::SvgElement& element, const scene::SceneShape& shape, const Stroke& stroke,
                         double width) {
    element.set("fill", "none").set("stroke", *stroke.color ? stroke.color : shape.color.value);
    element.set("stroke-opacity", stroke.opacity == 1.0 ? "" : svg::svg_number(stroke.opacity));
    element.set("stroke-linecap", "round").set("stroke-linejoin", "round");
    element.move("stroke-width", width * stroke.share);
  }

  void draw_strokes(const scene::SceneShape& shape, const std::vector<Point>& points,
                    const std::vector<Stroke>& strokes) {
    for (const Stroke& stroke : strokes) {
      svg::SvgElement line{points.size() == 2 ? "line" : "polyline"};
      if (points.size() == 2)
        line.move("x1", x(points[0]))
            .move("y1", y(points[0]))
            .move("x2", x(points[1]))
            .move("y2", y(points[1]));
      else
        line.attributes.push_back({"points", point_list(points), true});
      set_stroke(line, shape, stroke, scale_ * shape.width);
      add(std::move(line), shape);
    }
  }

  std::string point_list(const std::vector<Point>& points) const {
    std::string list;
    for (const Point& at : points)
      list += fmt::format("{}{},{}", list.empty() ? "" : " ", svg::svg_number(x(at)), svg::svg_number(y(at)));
    return list;
  }

  /// Draws a round bar: dark at its edges and light along its middle.
  void draw_rod(const scene::SceneShape& shape) {
    draw_strokes(shape, shape.points, {{1.25, 0.35, "#000000"}, {1.0, 1.0, ""}, {0.4, 0.45, "#ffffff"}});
  }

  /// Returns the line of a wall without indistinguishable points.
  std::vector<Point> seen_points(const scene::SceneWall& wall) const {
    geometry::Curve curve{std::vector<std::vector<double>>(2), 0};
    for (const Point& at : wall.points)
      for (std::size_t i = 0; i < 2; ++i) curve.columns[i].push_back(at[i]);
    const geometry::Curve thin = geometry::simplify(
        curve, {scene_.x[1] - scene_.x[0], scene_.y[1] - scene_.y[0]}, geometry::unseen, false);
    std::vector<Point> points;
    for (std::size_t i = 0; i < thin.size(); ++i) points.push_back({thin.columns[0][i], thin.columns[1][i]});
    return points;
  }

  void draw_wall(const scene::SceneShape& shape) {
    const scene::SceneWall& wall = shape.object->walls[shape.wall];
    std::string line;
    for (const Point& at : seen_points(wall))
      line +=
          fmt::format("{}{} {}", line.empty() ? "M" : "L", svg::svg_number(x(at)), svg::svg_number(y(at)));
    if (wall.closed) line += "Z";
    for (const Stroke& stroke : {Stroke{1.0, 1.0, ""}, Stroke{0.3, 0.35, "#ffffff"}}) {
      svg::SvgElement path{"path"};
      path.set("d", line);
      set_stroke(path, shape, stroke, scale_ * shape.width);
      add(std::move(path), shape);
    }
  }

  svg::SvgElement ring(const scene::SceneShape& shape) const {
    svg::SvgElement circle{"circle"};
    const Point& at = shape.points.front();
    return circle.move("cx", x(at)).move("cy", y(at)).move("r", std::max(0.0, scale_ * shape.size));
  }

  void draw_circle(const scene::SceneShape& shape) {
    svg::SvgElement circle = ring(shape);
    set_stroke(circle, shape, {1.0, 1.0, ""}, scale_ * shape.width);
    add(std::move(circle), shape);
  }

  void draw_disc(const scene::SceneShape& shape, bool ball) {
    add(ring(shape).set("fill", shape.color.value), shape);
    if (ball) return void(add(ring(shape).set("fill", "url(#light)"), shape));
    add(ring(shape).set("fill", "none").set("stroke", "#ffffff").set("stroke-width", 1.2), shape);
  }

  void draw_text(const scene::SceneShape& shape) {
    const Point& at = shape.points.front();
    // A text is never cut off, in any font: its size is reduced to fit, and it keeps a distance from the
    // edges.
    const double size = svg::fitted_size(shape.object->text, scale_ * shape.size, scene_width - 2.0 * edge);
    const double half = 0.5 * size * svg::text_width(shape.object->text), height = scene_height(scene_);
    svg::SvgElement text{"text"};
    text.move("x", std::max(edge + half, std::min(x(at), scene_width - edge - half)));
    text.move("y", std::max(edge + size, std::min(y(at), height - edge - 0.25 * size)));
    text.set("font-family", font).move("font-size", size);
    text.set("text-anchor", "middle").set("fill", shape.color.value);
    text.text = shape.object->text;
    add(std::move(text), shape);
  }

  const scene::Scene& scene_;
  svg::SvgElement& frame_;
  double scale_;
};

/// Returns the colours of the background: top and bottom.
std::array<std::string, 2> background_colors(const scene::Scene& scene) {
  if (scene.background == "dark") return {"#18222d", "#0a0f15"};
  if (scene.background == "light") return {"#fbfcfd", "#e3e9ee"};
  return {scene.background, scene.background};
}

constexpr double frames_per_second = 20.0;  // enough with linear motion in between
constexpr std::size_t min_frames = 2, max_frames = 600;

[[noreturn]] void nothing_to_show(const scene::Scene& scene, const std::string& file, const char* what) {
  throw yaml::Error(yaml::Fault{{file, scene.mark}, "scene.animation", what, {}});
}

std::string drawn(const scene::Scene& scene, const record::Recording& recording, const AnimationRows& chosen,
                  const std::string& title) {
  const scene::SceneView view = scene::view_of(scene, recording);
  std::vector<svg::SvgElement> frames;
  for (const std::size_t row : chosen.rows) {
    frames.push_back(scene_sheet(scene, scene_width, scene_height(scene), title));
    frames.back().add(scene_frame(scene, view.shapes(scene::row_of(recording, row))));
  }
  return svg::animated_svg(frames, chosen.seconds);
}

/// Returns the gradients of balls and of the background, which frames refer to.
svg::SvgElement scene_definitions(const scene::Scene& scene) {
  svg::SvgElement light{"radialGradient"};
  light.set("id", "light").set("cx", 0.36).set("cy", 0.32).set("r", 0.75);
  light.add(stop(0.0, "#ffffff", 0.85)).add(stop(0.35, "#ffffff", 0.1)).add(stop(1.0, "#000000", 0.55));
  svg::SvgElement ground{"linearGradient"};
  ground.set("id", "ground").set("x1", 0.0).set("y1", 0.0).set("x2", 0.0).set("y2", 1.0);
  const auto [above, below] = background_colors(scene);
  ground.add(stop(0.0, above, 1.0)).add(stop(1.0, below, 1.0));
  svg::SvgElement definitions{"defs"};
  definitions.add(std::move(light)).add(std::move(ground));
  return definitions;
}

}  // namespace

double scene_height(const scene::Scene& scene) {
  return std::round(scene_width * (scene.y[1] - scene.y[0]) / (scene.x[1] - scene.x[0]));
}

svg::SvgElement scene_frame(const scene::Scene& scene, const std::vector<scene::SceneShape>& shapes) {
  svg::SvgElement frame{"svg"};
  const double height = scene_height(scene);
  frame.set("x", 0.0).set("y", 0.0).set("width", scene_width).set("height", height);
  svg::SvgElement ground = rectangle(0.0, 0.0, scene_width, height);
  frame.add(ground.set("rx", 8.0).set("fill", "url(#ground)"));
  FramePen pen(scene, frame);
  for (const scene::SceneShape& shape : shapes) pen.draw(shape);
  return frame;
}

svg::SvgElement scene_sheet(const scene::Scene& scene, double width, double height,
                            const std::string& title) {
  svg::SvgElement sheet{"svg"};
  sheet.set("xmlns", "http://www.w3.org/2000/svg").set("width", width).set("height", height);
  sheet.set("viewBox", fmt::format("0 0 {} {}", svg::svg_number(width), svg::svg_number(height)));
  svg::SvgElement name{"title"};
  name.text = title;
  // A scene has its own colours; on a dark screen only the page around it is dark.
  svg::SvgElement style{"style"};
  style.text = "@media screen and (prefers-color-scheme: dark){.page{fill:#191919}.words{fill:#dddddd}}";
  sheet.add(std::move(name)).add(std::move(style)).add(scene_definitions(scene));
  return sheet;
}

std::string scene_still(const plot::SceneInstants& drawn, const std::string& title) {
  const auto& [owner, instants, words] = drawn;
  const scene::Scene& scene = *owner;
  const bool worded = std::ranges::any_of(words, [](const std::string& text) { return !text.empty(); });
  const std::size_t columns = instants.size() == 4 ? 2 : std::min<std::size_t>(3, instants.size());
  const std::size_t rows = (instants.size() + columns - 1) / columns;
  const double top = title.empty() ? margin : title_height,
               cell = scene_height(scene) + (worded ? words_height : 0.0);
  const double width = 2 * margin + static_cast<double>(columns) * (scene_width + gap) - gap;
  const double height = top + static_cast<double>(rows) * (cell + gap) - gap + margin;
  svg::SvgElement sheet = scene_sheet(scene, width, height, title);
  sheet.add(rectangle(0.0, 0.0, width, height).set("class", "page").set("fill", "#ffffff"));
  if (!title.empty()) sheet.add(words_at(0.5 * width, 23.0, 15.0, width - 2.0 * edge, title, "#111111"));
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const double left = margin + static_cast<double>(i % columns) * (scene_width + gap);
    const double upper = top + static_cast<double>(i / columns) * (cell + gap);
    svg::SvgElement frame = scene_frame(scene, instants[i]);
    frame.attributes[0].value = svg::svg_number(left);
    frame.attributes[1].value = svg::svg_number(upper);
    sheet.add(std::move(frame));
    if (!words[i].empty())
      sheet.add(words_at(left + 0.5 * scene_width, upper + scene_height(scene) + 18.0, 13.0, scene_width,
                         words[i], "#333333"));
  }
  return svg::svg_text(sheet);
}

AnimationRows animation_rows(const scene::Scene& scene, const std::string& file,
                             const record::Recording& recording, std::size_t most) {
  const query::RunRows run = query::rows_of_run(scene.animation.where, recording);
  if (run.none()) nothing_to_show(scene, file, "no row is left to be drawn");
  const std::vector<double>& time = recording.table.columns.front().values;
  std::vector<std::size_t> all;
  for (std::size_t row = run.begin; row < run.end; ++row)
    if (time[row] >= scene.animation.from.value_or(time[run.begin]) &&
        time[row] <= scene.animation.to.value_or(time[run.end - 1]))
      all.push_back(row);
  if (all.size() < min_frames) nothing_to_show(scene, file, "fewer than two rows are left to be drawn");
  const double between = (time[all[1]] - time[all[0]]) / scene.animation.speed;
  const auto smooth =
      static_cast<std::size_t>(std::max(1.0, std::round(1.0 / (frames_per_second * between))));
  const std::size_t step = std::min(all.size() - 1, std::max(smooth, (all.size() - 1) / (most - 1) + 1));
  AnimationRows chosen;
  // Counted from the last row, which often is the result of a run.
  for (std::size_t i = (all.size() - 1) % step; i < all.size(); i += step) chosen.rows.push_back(all[i]);
  chosen.seconds = (time[chosen.rows.back()] - time[chosen.rows.front()]) / scene.animation.speed;
  return chosen;
}

std::string animated_scene(const scene::Scene& scene, const std::string& file,
                           std::span<const record::Recording> recordings, const std::string& title) {
  const record::Recording& recording = recordings[scene.recording];
  for (std::size_t most = max_frames;; most = most * 2 / 3) {
    const AnimationRows rows = animation_rows(scene, file, recording, most);
    std::string picture = drawn(scene, recording, rows, title);
    if (picture.size() <= largest_animation || rows.rows.size() <= 2 * min_frames) return picture;
  }
}

}  // namespace stepwire::render
