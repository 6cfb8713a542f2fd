#include <fmt/format.h>

#include "engine/view/plot/overlay.hpp"
#include "engine/view/plot/panel_reading.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire {
namespace {

PanelKey range_key(const std::string& axis, std::string doc, AxisOptions Panel::*options) {
  const std::string name = axis + "_range";
  return {{name, std::move(doc), ValueType::number_pair},
          [=](Panel& panel, const Node& node, const KeyReading& read) {
            if (!node.is_list() || node.items.size() != 2)
              return read.fault(node.mark, name, "a range is two numbers: [-5 mm, 5 mm]");
            const auto end = [&](std::size_t i) {
              return read_axis_number(node.items[i], panel, axis, read.names, "figure." + name, read.faults);
            };
            const auto low = end(0), high = end(1);
            if (!low || !high) return;
            if (!(*low < *high))
              read.fault(node.mark, name, "the first number of a range is below the second");
            (panel.*options).range = {*low, *high};
          }};
}

PanelKey label_key(const std::string& axis, std::string doc, AxisOptions Panel::*options) {
  const std::string name = axis + "_label";
  return {{name, std::move(doc)}, [=](Panel& panel, const Node& node, const KeyReading& read) {
            (panel.*options).label = read.text(node, name);
          }};
}

void read_log(Panel& panel, const Node& node, const KeyReading& read) {
  static const FigureKey row{"log", "", ValueType::word, true, {"x", "y", "color"}};
  AxisOptions* const axes[] = {&panel.x, &panel.y, &panel.color};
  for (const Node& item : items_of(node))
    if (const auto axis = read.word(item, row)) axes[*axis]->log = true;
}

/// A row that a reader of its own sets, behind `stage`.
PanelKey own_key(FigureKey row, void (*read_it)(const Node&, Panel&, const Names&, Faults&), KeyNeeds needs,
                 KeyStage stage = KeyStage::options) {
  return {std::move(row),
          [=](Panel& panel, const Node& node, const KeyReading& read) {
            read_it(node, panel, read.names, read.faults);
          },
          needs, stage};
}

FigureKey expression(const char* name) {
  return {name, "", ValueType::expression};
}

FigureKey needed(FigureKey key) {
  key.required = true;
  return key;
}

}  // namespace

const std::vector<FigureKey>& motion_keys() {
  static const std::vector<FigureKey> keys{
      needed(expression("x")),
      needed(expression("y")),
      expression("where"),
      {"heads", "", ValueType::number},
      {"color", "", ValueType::word, false, {"red", "blue", "green", "black"}}};
  return keys;
}

const std::vector<FigureKey>& rose_keys() {
  static const std::vector<FigureKey> keys{needed(expression("x")),
                                           needed(expression("y")),
                                           needed(expression("angle")),
                                           needed({"value", "", ValueType::series}),
                                           expression("where"),
                                           {"at", "", ValueType::number_pair},
                                           needed({"radius", "", ValueType::number}),
                                           {"name", ""}};
  return keys;
}

PanelKey number_key(std::string name, std::string doc, std::optional<double> Panel::*member,
                    std::string axis) {
  return {
      {name, std::move(doc), ValueType::number}, [=](Panel& panel, const Node& node, const KeyReading& read) {
        if (const auto value = read_axis_number(node, panel, axis, read.names, "figure." + name, read.faults))
          panel.*member = *value;
      }};
}

PanelKey numbers_key(std::string name, std::string doc, std::vector<double> Panel::*member,
                     std::string axis) {
  return {{name, std::move(doc), ValueType::number, true},
          [=](Panel& panel, const Node& node, const KeyReading& read) {
            for (const Node& item : items_of(node))
              if (const auto value =
                      read_axis_number(item, panel, axis, read.names, "figure." + name, read.faults))
                (panel.*member).push_back(*value);
          }};
}

const std::vector<PanelKey>& panel_keys() {
  static const std::vector<PanelKey> keys{
      text_key("title", "text above the panel", &Panel::title),
      {{"where", "draws only rows for which this expression is true", ValueType::expression},
       [](Panel& panel, const Node& node, const KeyReading& read) {
         panel.where = read_formula(node, read.names, "figure.where", read.faults);
       }},
      word_key("rows", "all (default), or final: only the last row of each run of a sweep", {"all", "final"},
               &Panel::final_rows),
      {{"legend", "texts of the legend, in the order of the curves", ValueType::text, true},
       [](Panel& panel, const Node& node, const KeyReading& read) {
         for (const Node& item : items_of(node)) panel.legend.push_back(read.text(item, "legend"));
       }},
      truth_key("equal", "true: one unit is as long on both axes", &Panel::equal),
      range_key("x", "ends of the axis: [-5 mm, 5 mm]", &Panel::x),
      range_key("y", "ends of the axis", &Panel::y),
      label_key("x", "text at the axis, to which the unit is added", &Panel::x),
      label_key("y", "text at the axis", &Panel::y),
      label_key("z", "text at the axis", &Panel::z),
      label_key("color", "text at the colour bar", &Panel::color),
      range_key("z", "ends of the axis", &Panel::z),
      range_key("color", "values at both ends of the colour bar", &Panel::color),
      {{"log",
        "axes with a logarithmic scale: x, y, color, or a list",
        ValueType::word,
        true,
        {"x", "y", "color"}},
       read_log},
      own_key({"boundary",
               "expression of x and y in SI units (or a list); a line is drawn where it is zero: x - 5 mm. "
               "What is recorded stands for its value in the first row that 'where' selects",
               ValueType::text, true},
              read_boundaries, KeyNeeds::plane, KeyStage::rows),
      own_key({"note",
               "expression whose value in the first row that 'where' selects is shown in a corner: {signal: "
               "normalised, label: error}",
               ValueType::series},
              read_note, KeyNeeds::nothing, KeyStage::rows),
      {{"region", "name of a Region (or a list): its boundary is drawn, and its inside shaded",
        ValueType::text, true},
       [](Panel& panel, const Node& node, const KeyReading& read) { read_regions(node, panel, read); }},
      word_key("region_line", "how the boundary of a region is drawn: line or dashes", {"line", "dashes"},
               &Panel::dashed_regions),
      own_key({"marks", "points with names, drawn on top: {A: [0 mm, 20 mm]}; a list of points numbers them",
               ValueType::point_list},
              read_marks, KeyNeeds::both, KeyStage::points),
      own_key({"texts", "texts in the plane, each about its point: {authorized region: [0 mm, 200 mm]}",
               ValueType::points},
              read_texts, KeyNeeds::both, KeyStage::points),
      own_key({"motion",
               "the way of a point (or a list), drawn as a line with arrow heads: {x: hand.1, y: hand.2, "
               "where: time < 2 s, heads: 8, color: red}",
               ValueType::map,
               true,
               {},
               motion_keys()},
              read_motions, KeyNeeds::both),
      own_key({"rose",
               "what happens at a point in each direction (or a list), drawn as a disc with spokes as long "
               "as `value`: {x: at.1, y: at.2, angle: phi, value: force in N, where: time > 1 s, at: [5 mm, "
               "0 mm], radius: 4 mm, name: D2}",
               ValueType::map,
               true,
               {},
               rose_keys()},
              read_roses, KeyNeeds::both)};
  return keys;
}

}  // namespace stepwire
