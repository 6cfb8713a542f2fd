// Conversion of a mechanism for rig.mjs.
#include <algorithm>
#include <utility>

#include "engine/view/plot/rig.hpp"

namespace stepwire::plot {

namespace {

std::size_t dimensions_of(const Rig& rig) {
  std::size_t most = 2;
  for (const RigElement& element : rig.elements)
    for (const RigPoint& point : element.points) most = std::max(most, point.size());
  return most;
}

json::Json element_json(const RigElement& element, json::Json points) {
  json::Json json = json::Json::object().set("kind", element.kind).set("points", std::move(points));
  if (!element.name.empty()) json.set("name", element.name);
  if (element.body) json.set("body", *element.body);
  if (element.offset != 0.0) json.set("offset", element.offset);
  if (!element.direction.empty()) json.set("direction", json::Json::list_of(element.direction));
  return json;
}

}  // namespace

json::Json rig_json(
    const Rig& rig,
    const std::function<json::Json(const RigElement& element, std::size_t dimensions)>& points) {
  const std::size_t dimensions = dimensions_of(rig);
  json::Json elements = json::Json::list();
  for (const RigElement& element : rig.elements)
    elements.push(element_json(element, points(element, dimensions)));
  json::Json json = json::Json::object().set("title", rig.title).set("dimensions", dimensions);
  json.set("axes", json::Json::list_of(rig.axes));
  if (rig.z_up) json.set("up", "z");
  if (rig.schematic) json.set("schematic", true);
  return json.set("elements", std::move(elements));
}

}  // namespace stepwire::plot
