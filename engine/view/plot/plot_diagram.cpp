#include <fmt/format.h>

#include "engine/view/drawing/graph_faults.hpp"
#include "engine/view/plot/drawn.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {

using yaml::form;

namespace {

using DrawingRow = yaml::KeyRow<drawing::GraphOptions, query::NamesReading>;
using Texts = std::vector<std::string>;

constexpr int deepest = 32;

Texts words_of(const yaml::Node& node) {
  Texts found;
  for (const yaml::Node& item : node.as_list()) found.push_back(item.text);
  return found;
}

DrawingRow words_row(std::string name, std::string doc, Texts drawing::GraphOptions::*member) {
  return {std::move(name), std::move(doc), form::one_or_list(form::block()),
          [=](drawing::GraphOptions& options, const yaml::Node& node, const query::NamesReading&) {
            options.*member = words_of(node);
          }};
}

DrawingRow texts_row(std::string name, std::string doc,
                     std::map<std::string, std::string> drawing::GraphOptions::*member) {
  return {std::move(name), std::move(doc),
          form::naming(yaml::Key::Names::block, form::names(form::text(), 1)),
          [=](drawing::GraphOptions& options, const yaml::Node& node, const query::NamesReading& read) {
            if (!node.is_map()) read.fault(node.mark, "is a map of NAME: TEXT");
            for (const yaml::Entry& entry : node.entries)
              (options.*member)[entry.key] = read.text(entry.value);
          }};
}

void read_groups(drawing::GraphOptions& options, const yaml::Node& node, const query::NamesReading& read) {
  if (!node.is_map()) read.fault(node.mark, "'groups' is a map of NAME: [block, ...]");
  for (const yaml::Entry& entry : node.entries) {
    options.groups.push_back({entry.key, words_of(entry.value)});
    if (options.groups.back().members.empty())
      read.fault(entry.value.mark, fmt::format("the group '{}' has no blocks", entry.key));
  }
}

const std::vector<DrawingRow>& drawing_rows() {
  static const std::vector<DrawingRow> rows{
      words_row("open", "parts whose inside is drawn: rig, or a list", &drawing::GraphOptions::open),
      {"depth", "all parts are opened so many levels deep", form::whole(0, deepest),
       &drawing::GraphOptions::depth},
      words_row("hide",
                "blocks, parts and signals that are left out with their wires: work, rig.energy, or a list; "
                "'*' stands for any letters",
                &drawing::GraphOptions::hide),
      texts_row("labels", "texts on wires, by signal: {rig.force: F_d}; what follows '_' stands lower",
                &drawing::GraphOptions::labels),
      texts_row("names", "names that blocks and parts have in the drawing: {rig: mechanism}",
                &drawing::GraphOptions::names),
      {"groups",
       "frames with a name around blocks and parts of the file itself: {haptic platform: [platform, "
       "amplifier]}",
       form::names(form::one_or_list(form::block()), 1), read_groups},
      {"units", "units are written at the wires", form::truth(), &drawing::GraphOptions::units}};
  return rows;
}

/// Returns the place of the word of a fault in the file.
yaml::Mark place_of(const drawing::GraphFault& fault, const yaml::Node& figure) {
  const yaml::Node& node = *figure.find(fault.key);
  for (const yaml::Node& item : node.items)
    if (item.text == fault.word) return item.mark;
  for (const yaml::Entry& entry : node.entries) {
    if (entry.key == fault.word) return entry.mark;
    for (const yaml::Node& item : entry.value.items)
      if (item.text == fault.word) return item.mark;
  }
  return node.mark;
}

PanelContent read_diagram(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  if (!names.diagram) return {};
  const std::size_t before = faults.size();
  const query::NamesReading read("figure", names, faults);
  drawing::GraphOptions options;
  yaml::set_keys(node, drawing_rows(), options, read);
  for (const drawing::GraphFault& fault : drawing::faults_of(*names.diagram, options))
    yaml::below(read, fault.key).fault(place_of(fault, node), fault.message);
  if (faults.size() > before) return [](std::span<const record::Recording>) { return DrawnGraph{}; };
  json::Json graph = names.diagram->graph(options);
  if (const yaml::Node* title = node.find("title")) graph.set("title", title->text);
  return [graph](std::span<const record::Recording>) { return DrawnGraph{DrawnGraph::Kind::diagram, graph}; };
}

/// Returns the labelled signals by their labels: "labels.F_d".
std::vector<query::NamedFormula> labelled_signals(const yaml::Node& node, const query::SymbolTable&) {
  std::vector<query::NamedFormula> signals;
  const yaml::Node* labels = node.find("labels");
  for (std::size_t i = 0; labels && i < labels->entries.size(); ++i)
    signals.push_back(
        {"labels." + name_of_label(labels->entries[i].value.text, i + 1), labels->entries[i].key});
  return signals;
}

}  // namespace

PlotKind diagram_plot() {
  PlotKind kind;
  kind.name = "diagram";
  kind.doc = "the diagram itself, as blocks and wires";
  for (const DrawingRow& row : drawing_rows()) kind.options.push_back({row.name, row.doc, row});
  kind.plane = false;
  kind.read = read_diagram;
  kind.shown = labelled_signals;
  kind.reads_rows = [](const yaml::Node&) { return false; };
  return kind;
}

}  // namespace stepwire::plot
