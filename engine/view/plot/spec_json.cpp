#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::plot {

using json::Json;

namespace {

Json json_of(double value) {
  return value;
}
Json json_of(bool value) {
  return value;
}
Json json_of(std::size_t value) {
  return value;
}
Json json_of(const std::string& text) {
  return text;
}
Json json_of(PlotSpec::Legend legend) {
  return PlotSpec::legends[static_cast<std::size_t>(legend)];
}
Json json_of(TextMark::Align align) {
  return TextMark::alignments[static_cast<std::size_t>(align)];
}
Json json_of(PointsMark::Symbol symbol) {
  return PointsMark::symbols[static_cast<std::size_t>(symbol)];
}
template <std::size_t count>
Json json_of(const std::array<double, count>& numbers) {
  return Json::list_of(numbers);
}

/// Returns a column with the digits that are visible in a picture; non-finite numbers are null.
Json json_of(const std::vector<double>& column) {
  Json list = Json::list();
  for (const double value : column) list.push(query::rounded(value, 7));
  return list;
}

template <class Struct>
concept HasFields = requires {
  Struct::fields();
};

template <class Struct>
Json object_of(const Struct& value, Json json = Json::object());
template <HasFields Struct>
Json json_of(const Struct& value) {
  return object_of(value);
}
template <class... Marks>
Json json_of(const std::variant<Marks...>& mark);

template <class Value>
Json json_of(const std::optional<Value>& value) {
  return value ? json_of(*value) : Json();
}
template <class Value>
Json json_of(const std::vector<Value>& values) {
  Json list = Json::list();
  for (const Value& value : values) list.push(json_of(value));
  return list;
}
template <class... Marks>
Json json_of(const std::variant<Marks...>& mark) {
  return std::visit(
      [](const auto& one) {
        return object_of(one, Json::object().set("mark", std::decay_t<decltype(one)>::name));
      },
      mark);
}
/// True for a field with its default value, which is omitted.
template <class Value>
bool is_default(const Value& value, const Value& otherwise) {
  if constexpr (requires { value.empty(); })
    return value.empty();
  else
    return value == otherwise;
}

template <class Struct>
Json object_of(const Struct& value, Json json) {
  static const Struct usual{};
  const auto add = [&](const auto& field) {
    if (!is_default(value.*field.member, usual.*field.member))
      json.set(field.name, json_of(value.*field.member));
  };
  std::apply([&](const auto&... all) { (add(all), ...); }, Struct::fields());
  return json;
}

Json content_json(const PlotSpec& plot, Json json) {
  return object_of(plot, std::move(json.set("panel", "plot")));
}

Json content_json(const text::TextTable& table, Json json) {
  json.set("panel", "table").set("title", table.title).set("columns", Json::list_of(table.columns));
  Json rows = Json::list();
  for (const auto& row : table.rows) rows.push(Json::list_of(row));
  return json.set("rows", std::move(rows)).set("notes", Json::list_of(table.notes));
}

Json content_json(const DrawnGraph& drawn, Json json) {
  return json.set("panel", drawn.kind == DrawnGraph::Kind::rig ? "rig" : "diagram").set("graph", drawn.graph);
}

Json shape_json(const scene::SceneShape& shape) {
  const scene::SceneObject& object = *shape.object;
  Json json = Json::object().set("kind", object.kind->name).set("name", object.name);
  const bool wall = !object.walls.empty();
  Json points = Json::list();
  for (const auto& point : wall ? object.walls[shape.wall].points : shape.points)
    points.push(json_of(std::vector<double>(point.begin(), point.end())));
  json.set("points", std::move(points)).set("size", shape.size).set("width", shape.width);
  json.set("color", shape.color.value).set("shown", shape.shown);
  if (wall) json.set("closed", object.walls[shape.wall].closed);
  if (!object.text.empty()) json.set("text", object.text);
  return json;
}

Json content_json(const SceneInstants& drawn, Json json) {
  const scene::Scene& scene = *drawn.scene;
  json.set("panel", "scene").set("x", Json::list_of(scene.x)).set("y", Json::list_of(scene.y));
  Json instants = Json::list();
  for (std::size_t i = 0; i < drawn.shapes.size(); ++i) {
    Json shapes = Json::list();
    for (const scene::SceneShape& shape : drawn.shapes[i]) shapes.push(shape_json(shape));
    instants.push(Json::object().set("words", drawn.words[i]).set("shapes", std::move(shapes)));
  }
  return json.set("background", scene.background).set("instants", std::move(instants));
}

Json panel_json(const PanelSpec& panel) {
  Json json = Json::object();
  if (panel.width > 0.0) json.set("box", Json::list({panel.left, panel.top, panel.width, panel.height}));
  return std::visit([&](const auto& content) { return content_json(content, std::move(json)); },
                    panel.content);
}

}  // namespace

Json figure_json(const FigureSpec& figure) {
  Json json = Json::object().set("title", figure.title);
  if (figure.width > 0.0) json.set("width", figure.width).set("height", figure.height);
  if (figure.aligned) json.set("aligned", true);
  Json panels = Json::list();
  for (const PanelSpec& panel : figure.panels) panels.push(panel_json(panel));
  return json.set("panels", std::move(panels));
}

}  // namespace stepwire::plot
