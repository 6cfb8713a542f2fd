#include "engine/app/studio/live/mechanisms.hpp"

#include <algorithm>

#include "engine/view/drawing/draw.hpp"
#include "engine/view/plot/rig.hpp"

namespace stepwire::live {

namespace {

using json::Json;

Json point_of(const plot::RigPoint& point) {
  Json coordinates = Json::list();
  for (const auto& coordinate : point) {
    const auto* formula = std::get_if<query::Formula>(&coordinate);
    coordinates.push(formula ? Json(formula->text) : Json(std::get<double>(coordinate)));
  }
  return coordinates;
}

Json points_of(const plot::RigElement& element) {
  Json points = Json::list();
  for (const plot::RigPoint& point : element.points) points.push(point_of(point));
  return points;
}

Json mechanism_of(const plot::Rig& rig) {
  return plot::rig_json(rig, [](const plot::RigElement& element, std::size_t) { return points_of(element); });
}

/// Collects all maps of `plot: rig` in a section `figure`, including its panels.
void find_rigs(const yaml::Node& figure, std::vector<const yaml::Node*>& rigs) {
  const yaml::Node* kind = figure.find("plot");
  if (kind && kind->text == "rig") rigs.push_back(&figure);
  if (const yaml::Node* panels = figure.find("panels")) find_rigs(*panels, rigs);
  for (const yaml::Node& item : figure.items) find_rigs(item, rigs);
}

void add_rigs(const LoadedRun& run, Json& list) {
  const diagram::Diagram& diagram = run.plan().diagram;
  const Registry no_blocks;
  diagram::Loader no_files(no_blocks);  // reads no files: names are resolved in the diagram
  const drawing::DiagramView view(diagram, no_files);
  query::SymbolTable names = run.signals().names(run.plan());
  names.diagram = &view;
  std::vector<const yaml::Node*> nodes;
  find_rigs(diagram.figure, nodes);
  for (const yaml::Node* node : nodes) {
    yaml::Faults faults;
    plot::Rig rig = plot::read_rig(*node, names, faults);
    if (const yaml::Node* title = node->find("title")) rig.title = title->text;
    if (faults.empty()) list.push(mechanism_of(rig));
  }
}

/// Returns the signals of a linkage's pin: those of its output or of the source of its input `position`.
Json pin_of(const LoadedRun& run, std::size_t index) {
  const diagram::DiagramBlock& block = run.plan().diagram.blocks[index];
  const plan::PlannedBlock& planned = run.plan().blocks[index];
  std::optional<plan::SignalSlot> slot;
  for (std::size_t i = 0; i < block.type().inputs.size(); ++i)
    if (block.type().inputs[i].name == "position" && !planned.inputs[i].empty())
      slot = planned.inputs[i].front();
  for (std::size_t o = 0; o < block.type().outputs.size(); ++o)
    if (block.type().outputs[o].name == "position") slot = planned.outputs[o];
  Json coordinates = Json::list();
  const auto& signals = run.signals().all();
  for (Eigen::Index k = 0; slot && k < slot->size; ++k) {
    const std::size_t offset = slot->offset + static_cast<std::size_t>(k);
    const auto found = std::ranges::find(signals, offset, &LiveSignal::offset);
    if (found != signals.end()) coordinates.push(found->name);
  }
  return coordinates;
}

Value value_of(const diagram::DiagramBlock& block, const char* parameter) {
  const ParameterSpec* spec = block.type().parameter(parameter);
  return spec && spec->get ? spec->get(block.block.get()) : Value{};
}

Json linkage_of(const LoadedRun& run, std::size_t index, const Eigen::MatrixXd& anchors) {
  const diagram::DiagramBlock& block = run.plan().diagram.blocks[index];
  const Json pin = pin_of(run, index);
  const Value shortest = value_of(block, "shortest");
  const double* length = std::get_if<double>(&shortest.content);
  Json elements = Json::list(), feet = Json::list();
  for (Eigen::Index row = 0; row < anchors.rows(); ++row) {
    Json foot = Json::list();
    for (Eigen::Index k = 0; k < anchors.cols(); ++k) foot.push(anchors(row, k));
    Json damper = Json::object().set("kind", "damper").set("points", Json::list({foot, pin}));
    if (length) damper.set("body", *length / 2.0);
    elements.push(std::move(damper));
    feet.push(std::move(foot));
  }
  elements.push(Json::object().set("kind", anchors.cols() > 2 ? "universal" : "ground").set("points", feet));
  elements.push(Json::object().set("kind", "end_effector").set("points", Json::list({pin})));
  return Json::object()
      .set("title", block.name)
      .set("dimensions", anchors.cols())
      .set("axes", Json::list({"x", "y", "z"}))
      .set("elements", std::move(elements));
}

void add_linkages(const LoadedRun& run, Json& list) {
  const auto& blocks = run.plan().diagram.blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::string& type = blocks[b].type().name;
    if (type != "Linkage" && type != "DrivenLinkage") continue;
    const Value anchors = value_of(blocks[b], "anchors");
    if (const auto* rows = std::get_if<Eigen::MatrixXd>(&anchors.content))
      list.push(linkage_of(run, b, *rows));
  }
}

}  // namespace

Json mechanisms_of(const LoadedRun& run) {
  Json list = Json::list();
  add_rigs(run, list);
  if (list.items().empty()) add_linkages(run, list);
  return Json::object().set("mechanisms", std::move(list));
}

}  // namespace stepwire::live
