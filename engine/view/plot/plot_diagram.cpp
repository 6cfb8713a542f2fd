#include <fmt/format.h>

#include <cmath>

#include "engine/analyse/query/number.hpp"
#include "engine/view/drawing/graph_faults.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire {
namespace {

constexpr int deepest = 32;

/// Reads the options of a drawn diagram; faults are gathered.
class DiagramPlotReader {
 public:
  DiagramPlotReader(const Node& node, const Names& names, Faults& faults)
      : node_(node), names_(names), faults_(faults) {}

  GraphOptions read() {
    options_.open = words("open");
    options_.hide = words("hide");
    options_.labels = texts("labels");
    options_.names = texts("names");
    if (const Node* groups = node_.find("groups")) read_groups(*groups);
    if (const Node* depth = node_.find("depth")) read_depth(*depth);
    if (const Node* units = node_.find("units")) read_units(*units);
    for (GraphFault& fault : faults_of(*names_.diagram, options_))
      this->fault(place_of(fault), fault.key, std::move(fault.message));
    return options_;
  }

 private:
  void fault(const Mark& mark, const std::string& key, std::string message) {
    faults_.add({{names_.file, mark}, "figure." + key, std::move(message), {}});
  }

  /// Where the file has a word.
  Mark place_of(const GraphFault& fault) const {
    const Node& node = *node_.find(fault.key);
    for (const Node& item : node.items)
      if (item.text == fault.word) return item.mark;
    for (const Entry& entry : node.entries) {
      if (entry.key == fault.word) return entry.mark;
      for (const Node& item : entry.value.items)
        if (item.text == fault.word) return item.mark;
    }
    return node.mark;
  }

  std::vector<std::string> words_of(const Node& node) const {
    if (node.is_scalar()) return {node.text};
    std::vector<std::string> found;
    for (const Node& item : node.items) found.push_back(item.text);
    return found;
  }

  std::vector<std::string> words(const std::string& key) const {
    const Node* node = node_.find(key);
    return node ? words_of(*node) : std::vector<std::string>{};
  }

  std::map<std::string, std::string> texts(const std::string& key) {
    std::map<std::string, std::string> found;
    const Node* node = node_.find(key);
    if (!node) return found;
    if (!node->is_map()) fault(node->mark, key, fmt::format("'{}' is a map of NAME: TEXT", key));
    for (const Entry& entry : node->entries)
      found[entry.key] = read_text(entry.value, names_, "figure." + key, faults_);
    return found;
  }

  void read_groups(const Node& node) {
    if (!node.is_map()) fault(node.mark, "groups", "'groups' is a map of NAME: [block, ...]");
    for (const Entry& entry : node.entries) {
      options_.groups.push_back({entry.key, words_of(entry.value)});
      if (options_.groups.back().members.empty())
        fault(entry.value.mark, "groups", fmt::format("the group '{}' has no blocks", entry.key));
    }
  }

  void read_depth(const Node& node) {
    const auto depth = read_number(node, names_, "figure.depth", faults_);
    if (!depth) return;
    if (depth->value >= 0.0 && depth->value <= deepest && depth->value == std::floor(depth->value))
      options_.depth = static_cast<int>(depth->value);
    else
      fault(node.mark, "depth",
            fmt::format("{} is not allowed; it must be a whole number from 0 to {}", depth->text, deepest));
  }

  void read_units(const Node& node) {
    options_.units = node.text == "true";
    if (node.text != "true" && node.text != "false")
      fault(node.mark, "units", fmt::format("'{}' is not allowed; it is one of true, false", node.text));
  }

  const Node& node_;
  const Names& names_;
  Faults& faults_;
  GraphOptions options_;
};

PanelContent read_diagram(const Node& node, const Names& names, Faults& faults) {
  if (!names.diagram) return {};
  const std::size_t before = faults.size();
  const GraphOptions options = DiagramPlotReader(node, names, faults).read();
  if (faults.size() > before) return [](std::span<const Recording>) { return DrawnGraph{}; };
  Json graph = names.diagram->graph(options);
  if (const Node* title = node.find("title")) graph.set("title", title->text);
  return [graph](std::span<const Recording>) { return DrawnGraph{DrawnGraph::Kind::diagram, graph}; };
}

}  // namespace

PlotKind diagram_plot() {
  PlotKind kind;
  kind.name = "diagram";
  kind.doc = "the diagram itself, as blocks and wires";
  kind.options = {
      {{"open", "parts whose inside is drawn: rig, or a list", ValueType::text, true}},
      {{"depth", "all parts are opened so many levels deep (0)", ValueType::number}},
      {{"hide",
        "blocks, parts and signals that are left out with their wires: work, rig.energy, or a list; '*' "
        "stands for any letters",
        ValueType::text, true}},
      {{"labels", "texts on wires, by signal: {rig.force: F_d}; what follows '_' stands lower",
        ValueType::text_map}},
      {{"names", "names that blocks and parts have in the drawing: {rig: mechanism}", ValueType::text_map}},
      {{"groups",
        "frames with a name around blocks and parts of the file itself: {haptic platform: [platform, "
        "amplifier]}",
        ValueType::name_map}},
      {{"units", "units are written at the wires", ValueType::truth}}};
  kind.plane = false;
  kind.read = read_diagram;
  return kind;
}

}  // namespace stepwire
