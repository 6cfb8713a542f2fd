#include "engine/app/studio/live/scene_now.hpp"

#include <algorithm>

#include "engine/app/studio/live/pointer.hpp"
#include "engine/app/studio/live/recorded_so_far.hpp"

namespace stepwire::live {

namespace {

using json::Json;

Json point_json(const std::array<double, 2>& point) {
  return Json::list({point[0], point[1]});
}

Json points_json(const std::vector<std::array<double, 2>>& points) {
  Json list = Json::list();
  for (const auto& point : points) list.push(point_json(point));
  return list;
}

Json object_json(const scene::SceneObject& object) {
  Json walls = Json::list();
  for (const scene::SceneWall& wall : object.walls)
    walls.push(Json::object().set("points", points_json(wall.points)).set("closed", wall.closed));
  return Json::object()
      .set("name", object.name)
      .set("kind", object.kind->name)
      .set("text", object.text)
      .set("walls", std::move(walls));
}

Json shape_json(const scene::SceneShape& shape, const scene::Scene& scene) {
  Json json = Json::object().set("object", shape.object - scene.objects.data());
  if (!shape.object->walls.empty()) json.set("wall", shape.wall);
  return json.set("points", points_json(shape.points))
      .set("size", shape.size)
      .set("width", shape.width)
      .set("color", shape.color.value)
      .set("crossed", shape.crossed)
      .set("shown", shape.shown);
}

Json pointer_json(const diagram::Diagram& diagram) {
  if (!offers_pointer(diagram)) return {};
  return Json::object()
      .set("hand", has_pointer(diagram))
      .set("name", pointer_input)
      .set("held", held_input)
      .set("unit", "m")
      .set("text",
           "Resistance is seen here, not felt: the pin lags behind the pointer where something resists.");
}

}  // namespace

SceneNow::SceneNow(LoadedRun& run) : run_(run), scene_(*run.model().scene) {
  const std::int64_t last = std::max<std::int64_t>(0, run.store().end_tick() - 1);
  const auto now = recorded_so_far(run.model(), run.signals(), run.thread(), true, last);
  std::vector<std::string> names;
  for (const table::Column& column : now[scene_.recording].table.columns) {
    if (const auto signal = run.signals().find(column.name)) {
      columns_.push_back(run.stored(*signal));
      places_.push_back(names.size());
    }
    fixed_.push_back(column.values.empty() ? 0.0 : column.values.back());
    names.push_back(column.name);
  }
  view_.emplace(scene_, names);
}

Json SceneNow::description() const {
  Json objects = Json::list();
  for (const scene::SceneObject& object : scene_.objects) objects.push(object_json(object));
  return Json::object()
      .set("title", run_.plan().diagram.title)
      .set("x", point_json(scene_.x))
      .set("y", point_json(scene_.y))
      .set("background", scene_.background)
      .set("pointer", pointer_json(run_.plan().diagram))
      .set("objects", std::move(objects));
}

std::optional<Json> SceneNow::news() const {
  const std::optional<double> input = run_.thread().status().input;  // read before the samples that it caused
  const std::int64_t tick = run_.store().end_tick() - 1;
  if (tick < 0) return std::nullopt;
  std::vector<double> row = fixed_;
  row.front() = run_.store().time_of(tick);
  for (std::size_t i = 0; i < columns_.size(); ++i)
    run_.store().read(columns_[i], tick, {&row[places_[i]], 1});
  Json shapes = Json::list();
  for (const scene::SceneShape& shape : view_->shapes(row)) shapes.push(shape_json(shape, scene_));
  return Json::object()
      .set("news", "scene")
      .set("time", row.front())
      .set("input", input ? Json(*input) : Json())
      .set("shapes", std::move(shapes));
}

}  // namespace stepwire::live
