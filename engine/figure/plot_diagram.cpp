#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/draw/draw.hpp"
#include "engine/figure/number.hpp"
#include "engine/figure/plot_kind.hpp"

namespace stepwire {
namespace {

constexpr int deepest = 32;

/// Reads the options of a drawn diagram; faults are gathered.
class DiagramPlotReader {
 public:
  DiagramPlotReader(const Node& node, const Names& names, Faults& faults)
      : node_(node), names_(names), faults_(faults) {}

  GraphOptions read() {
    if (const Node* open = node_.find("open")) read_open(*open);
    if (const Node* depth = node_.find("depth")) read_depth(*depth);
    if (const Node* units = node_.find("units")) read_units(*units);
    return options_;
  }

 private:
  void fault(const Node& node, const std::string& key, std::string message) {
    faults_.add({{names_.file, node.mark}, "figure." + key, std::move(message), {}});
  }

  void read_open(const Node& node) {
    const std::vector<std::string> parts = names_.diagram->parts();
    const std::vector<Node> one{node};
    for (const Node& item : node.is_list() ? node.items : one) {
      if (std::find(parts.begin(), parts.end(), item.text) == parts.end())
        fault(
            item, "open",
            fmt::format("there is no part '{}'{}", item.text, nearest_or_all(item.text, parts, "there are")));
      options_.open.push_back(item.text);
    }
  }

  void read_depth(const Node& node) {
    const auto depth = read_number(node, names_, "figure.depth", faults_);
    if (!depth) return;
    if (depth->value >= 0.0 && depth->value <= deepest && depth->value == std::floor(depth->value))
      options_.depth = static_cast<int>(depth->value);
    else
      fault(node, "depth",
            fmt::format("{} is not allowed; it must be a whole number from 0 to {}", depth->text, deepest));
  }

  void read_units(const Node& node) {
    options_.units = node.text == "true";
    if (node.text != "true" && node.text != "false")
      fault(node, "units", fmt::format("'{}' is not allowed; it is one of true, false", node.text));
  }

  const Node& node_;
  const Names& names_;
  Faults& faults_;
  GraphOptions options_;
};

Picture read_diagram(const Node& node, const Names& names, Faults& faults) {
  if (!names.diagram) return {};
  const GraphOptions options = DiagramPlotReader(node, names, faults).read();
  Json graph = names.diagram->graph(options);
  if (const Node* title = node.find("title")) graph.set("title", title->text);
  return [graph](std::span<const Recording>) { return draw_picture(graph); };
}

}  // namespace

PlotKind diagram_plot() {
  PlotKind kind;
  kind.name = "diagram";
  kind.doc = "the diagram itself, as blocks and wires";
  kind.options = {{"open", "parts whose inside is drawn: rig, or a list", "", false, {}, Option::Form::names},
                  {"depth", "all parts are opened so many levels deep (0)"},
                  {"units", "units are written at the wires", "", false, {"true", "false"}}};
  kind.plane = false;
  kind.read = read_diagram;
  return kind;
}

}  // namespace stepwire
