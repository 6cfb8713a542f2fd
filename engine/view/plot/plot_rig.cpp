#include <fmt/format.h>

#include "engine/analyse/query/formula.hpp"
#include "engine/analyse/query/run_rows.hpp"
#include "engine/view/plot/drawn.hpp"
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

/// Returns all points of a path, for other elements the point at the first row.
Json points_of(const RigElement& element, const record::Recording& recording, const query::RunRows& rows,
               std::size_t dimensions) {
  if (element.kind == "path") return path_of(element.points.front(), recording, rows, dimensions);
  Json points = Json::list();
  for (const RigPoint& point : element.points)
    points.push(PointValues(point, recording).at(rows.first, dimensions));
  return points;
}

DrawnGraph drawn_mechanism(const Rig& rig, const std::string& file,
                           std::span<const record::Recording> recordings) {
  const record::Recording& recording = recordings[rig.recording];
  const query::RunRows rows = query::rows_of_run(rig.where, recording);
  if (rows.none())
    throw yaml::Error(yaml::Fault{{file, rig.mark}, "figure.where", "no row is left to be drawn", {}});
  return {DrawnGraph::Kind::rig, rig_json(rig, [&](const RigElement& element, std::size_t dimensions) {
            return points_of(element, recording, rows, dimensions);
          })};
}

PanelContent read_mechanism(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  Rig rig = read_rig(node, names, faults);
  if (const yaml::Node* title = node.find("title")) rig.title = title->text;
  return [rig = std::move(rig), file = names.file](std::span<const record::Recording> recordings) {
    return drawn_mechanism(rig, file, recordings);
  };
}

constexpr const char* axes[] = {"x", "y", "z"};

std::string text_of(const std::variant<double, query::Formula>& coordinate, const query::SymbolTable& names) {
  const auto* formula = std::get_if<query::Formula>(&coordinate);
  return formula ? formula->text
                 : query::number_text(std::get<double>(coordinate), unit::Dimension{{1}}, names);
}

/// Adds the points of an element and its direction: "elements.F_e.x", "elements.F_e.2.x" for its second
/// point, "elements.F_e.direction.x".
void add_element(const RigElement& element, const std::string& name, const query::SymbolTable& names,
                 std::vector<query::NamedFormula>& shown) {
  for (std::size_t point = 0; point < element.points.size(); ++point)
    for (std::size_t i = 0; i < element.points[point].size(); ++i) {
      const std::string text = text_of(element.points[point][i], names);
      shown.push_back({fmt::format("{}.{}.{}", name, point + 1, axes[i]), text});
      if (point == 0) shown.push_back({fmt::format("{}.{}", name, axes[i]), text});
    }
  for (std::size_t i = 0; i < element.direction.size(); ++i)
    shown.push_back({fmt::format("{}.direction.{}", name, axes[i]),
                     query::number_text(element.direction[i], std::nullopt, names)});
}

/// Returns the elements with names; faults are those of read_mechanism().
std::vector<query::NamedFormula> named_elements(const yaml::Node& node, const query::SymbolTable& names) {
  yaml::Faults faults;
  const Rig rig = read_rig(node, names, faults);
  std::vector<query::NamedFormula> shown;
  for (std::size_t i = 0; faults.empty() && i < rig.elements.size(); ++i)
    if (const RigElement& element = rig.elements[i]; !element.name.empty())
      add_element(element, "elements." + name_of_label(element.name, i + 1), names, shown);
  return shown;
}

}  // namespace

PlotKind rig_plot() {
  PlotKind kind;
  kind.name = "rig";
  kind.doc = "a mechanism to scale, at one instant of the run";
  for (const yaml::Key& key : rig_form().of) kind.options.push_back(described_key(key));
  kind.plane = false;
  kind.read = read_mechanism;
  kind.shown = named_elements;
  return kind;
}

}  // namespace stepwire::plot
