#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/run_rows.hpp"
#include "engine/view/plot/plot_kind.hpp"
#include "engine/view/plot/rig.hpp"

namespace stepwire::plot {

using json::Json;

namespace {

constexpr std::size_t max_points_of_path = 400;

/// Values of a point's coordinates in all rows.
class PointValues {
 public:
  PointValues(const RigPoint& point, const record::Recording& recording) {
    for (const auto& coordinate : point) {
      const auto* formula = std::get_if<query::Formula>(&coordinate);
      columns_.push_back(formula ? query::evaluate(*formula, recording)
                                 : std::vector<double>(recording.table.rows(), std::get<double>(coordinate)));
    }
  }

  Json at(std::size_t row, std::size_t dimensions) const {
    Json point = Json::list();
    for (std::size_t i = 0; i < dimensions; ++i) point.push(i < columns_.size() ? columns_[i][row] : 0.0);
    return point;
  }

 private:
  std::vector<std::vector<double>> columns_;
};

Json path_of(const RigPoint& point, const record::Recording& recording, const query::RunRows& rows,
             std::size_t dimensions) {
  const PointValues values(point, recording);
  const std::size_t step = (rows.end - rows.begin) / max_points_of_path + 1;
  Json points = Json::list();
  for (std::size_t row = rows.begin; row < rows.end; row += step) points.push(values.at(row, dimensions));
  if ((rows.end - 1 - rows.begin) % step != 0) points.push(values.at(rows.end - 1, dimensions));
  return points;
}

Json element_json(const RigElement& element, const record::Recording& recording, const query::RunRows& rows,
                  std::size_t dimensions) {
  Json points = Json::list();
  if (element.kind == "path")
    points = path_of(element.points.front(), recording, rows, dimensions);
  else
    for (const RigPoint& point : element.points)
      points.push(PointValues(point, recording).at(rows.first, dimensions));
  Json json = Json::object().set("kind", element.kind).set("points", std::move(points));
  if (!element.name.empty()) json.set("name", element.name);
  if (element.body) json.set("body", *element.body);
  if (element.offset != 0.0) json.set("offset", element.offset);
  if (!element.direction.empty()) json.set("direction", Json::list_of(element.direction));
  return json;
}

std::size_t dimensions_of(const Rig& rig) {
  std::size_t most = 2;
  for (const RigElement& element : rig.elements)
    for (const RigPoint& point : element.points) most = std::max(most, point.size());
  return most;
}

DrawnGraph drawn_mechanism(const Rig& rig, const std::string& file,
                           std::span<const record::Recording> recordings) {
  const record::Recording& recording = recordings[rig.recording];
  const query::RunRows rows = query::rows_of_run(rig.where, recording);
  if (rows.none())
    throw yaml::Error(yaml::Fault{{file, rig.mark}, "figure.where", "no row is left to be drawn", {}});
  const std::size_t dimensions = dimensions_of(rig);
  Json elements = Json::list();
  for (const RigElement& element : rig.elements)
    elements.push(element_json(element, recording, rows, dimensions));
  Json drawn = Json::object().set("title", rig.title).set("dimensions", dimensions);
  drawn.set("axes", Json::list_of(rig.axes));
  if (rig.z_up) drawn.set("up", "z");
  if (rig.schematic) drawn.set("schematic", true);
  return {DrawnGraph::Kind::rig, drawn.set("elements", std::move(elements))};
}

PanelContent read_mechanism(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  Rig rig = read_rig(node, names, faults);
  if (const yaml::Node* title = node.find("title")) rig.title = title->text;
  return [rig = std::move(rig), file = names.file](std::span<const record::Recording> recordings) {
    return drawn_mechanism(rig, file, recordings);
  };
}

}  // namespace

PlotKind rig_plot() {
  PlotKind kind;
  kind.name = "rig";
  kind.doc = "a mechanism to scale, at one instant of the run";
  for (const yaml::Key& key : rig_form().of) kind.options.push_back(described_key(key));
  kind.plane = false;
  kind.read = read_mechanism;
  return kind;
}

}  // namespace stepwire::plot
