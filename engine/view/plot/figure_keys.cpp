#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/overlay.hpp"
#include "engine/view/plot/panel_reading.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {

using yaml::form;

namespace {

std::optional<double> read_number(const yaml::Node& node, const Panel& panel, const std::string& axis,
                                  const query::NamesReading& read) {
  return read_axis_number(node, panel, axis, read.names, read.subject, read.faults);
}

PanelKey needing(KeyNeeds needs, PanelKey key) {
  key.needs = needs;
  return key;
}

PanelKey range_key(const std::string& axis, std::string doc, AxisOptions Panel::*options) {
  const yaml::Key form = yaml::like("[-5 mm, 5 mm]", form::pair(form::number()));
  return {axis + "_range", std::move(doc), form,
          [=](Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
            const auto* ends = read.pair(node, form);
            if (!ends) return;
            const auto low = read_number((*ends)[0], panel, axis, read);
            const auto high = read_number((*ends)[1], panel, axis, read);
            if (!low || !high) return;
            if (!(*low < *high)) read.fault(node.mark, "the first number of a range is below the second");
            (panel.*options).range = {*low, *high};
          }};
}

PanelKey label_key(const std::string& axis, std::string doc, AxisOptions Panel::*options) {
  return {axis + "_label", std::move(doc), form::text(),
          [=](Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
            (panel.*options).label = read.text(node);
          }};
}

void read_log(Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
  AxisOptions* const axes[] = {&panel.x, &panel.y, &panel.color};
  constexpr KeyNeeds needs[] = {KeyNeeds::across, KeyNeeds::up, KeyNeeds::color_bar};
  for (const yaml::Node& item : node.as_list()) {
    const auto axis = read.word(item, form::word({"x", "y", "color"}));
    if (!axis) continue;
    if (!panel.kind->takes(needs[*axis]))
      read.fault(item.mark, fmt::format("a plot '{}' has no numbers along '{}'; leave it out",
                                        panel.kind->name, item.text));
    axes[*axis]->log = true;
  }
}

/// Returns a row with its own reader, which runs after `stage`.
PanelKey own_key(std::string name, std::string doc, yaml::Key form,
                 void (*read_it)(const yaml::Node&, Panel&, const query::NamesReading&), KeyNeeds needs,
                 KeyStage stage = KeyStage::options) {
  PanelKey key{std::move(name), std::move(doc), std::move(form),
               [=](Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
                 read_it(node, panel, read);
               }};
  key.needs = needs;
  key.stage = stage;
  return key;
}

yaml::Key plane_point() {
  return form::pair(form::number());
}

void read_size(Figure& figure, const yaml::Node& node, const query::NamesReading& read) {
  const auto* size = read.pair(node, yaml::like("[640, 420]", {}));
  if (!size) return;
  read.take((*size)[0], form::whole(100, 4000), figure.width);
  read.take((*size)[1], form::whole(80, 4000), figure.height);
}

const char* const figure_example = "{plot: lines, x: time, y: rig.x}";

/// Adds keys that are not in the list yet.
template <class AnyRow>
void add(const std::vector<AnyRow>& rows, std::vector<yaml::Key>& keys) {
  for (const AnyRow& row : rows)
    if (std::ranges::find(keys, row.name, &yaml::Key::name) == keys.end()) keys.push_back(row);
}

yaml::Key channel_key(const Channel& channel) {
  yaml::Key form = channel.several ? form::one_or_list(form::series()) : form::series();
  yaml::Key made = key(channel.key, channel.doc, std::move(form));
  made.otherwise = channel.otherwise;
  return channel.required ? yaml::needed(std::move(made)) : made;
}

/// Returns the keys of a picture of one plot.
std::vector<yaml::Key> own_picture_keys() {
  std::vector<yaml::Key> keys;
  add(picture_keys(), keys);
  std::erase_if(keys, [](const yaml::Key& key) { return key.name == "panels"; });
  return keys;
}

std::vector<yaml::Key> keys_of_axes(const PlotKind& kind) {
  std::vector<PanelKey> rows = panel_keys();
  std::erase_if(rows, [&](const PanelKey& row) { return !kind.takes(row.needs); });
  return {rows.begin(), rows.end()};
}

}  // namespace

const yaml::Key& motion_form() {
  static const yaml::Key form = form::keys(
      "a motion", "{x: hand.1, y: hand.2}",
      {yaml::needed(yaml::key("x", "across", form::expression())),
       yaml::needed(yaml::key("y", "up", form::expression())),
       yaml::key("where", "only these rows", form::expression()),
       yaml::key("heads", "how many arrow heads it has, 0 to 100", form::number()),
       yaml::key("color", "of the line", form::word(yaml::words_of(form::words(motion_colors()))))});
  return form;
}

const yaml::Key& rose_form() {
  static const yaml::Key form =
      form::keys("a rose", "{x: at.1, y: at.2, angle: phi, value: force in N, radius: 4 mm}",
                 {yaml::needed(yaml::key("x", "across, where it happens", form::expression())),
                  yaml::needed(yaml::key("y", "up, where it happens", form::expression())),
                  yaml::needed(yaml::key("angle", "direction", form::expression())),
                  yaml::needed(yaml::key("value", "length of the spoke", form::series())),
                  yaml::key("where", "only these rows", form::expression()),
                  yaml::key("at", "where its middle is drawn", yaml::like("[0 mm, 20 mm]", plane_point())),
                  yaml::needed(yaml::key("radius", "of the disc, along x", form::number())),
                  yaml::key("name", "text beside it")});
  return form;
}

PanelKey described_key(const yaml::Key& key) {
  PanelKey described(key.name, key.doc, key);
  static_cast<yaml::Key&>(described) = key;
  return described;
}

PanelKey key_of_numbers(std::string name, std::string doc, bool several, std::string axis,
                        std::function<void(Panel&, double)> take) {
  return {std::move(name), std::move(doc), several ? form::one_or_list(form::number()) : form::number(),
          [=](Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
            const auto add = [&](const yaml::Node& item) {
              if (const auto value = read_number(item, panel, axis, read)) take(panel, *value);
            };
            if (!several) return add(node);
            for (const yaml::Node& item : node.as_list()) add(item);
          }};
}

const std::vector<PanelKey>& panel_keys() {
  static const std::vector<PanelKey> keys{
      {"title", "text above the panel", form::text(), &Panel::title},
      needing(KeyNeeds::choice, {"where", "draws only rows for which this expression is true",
                                 form::expression(), &Panel::where}),
      needing(KeyNeeds::rows, {"rows", "all, or final: only the last row of each run of a sweep",
                               form::word({"all", "final"}), &Panel::final_rows}),
      needing(KeyNeeds::legend,
              {"legend", "texts of the legend, in the order of the curves", form::one_or_list(form::text()),
               [](Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
                 for (const yaml::Node& item : node.as_list()) panel.legend.push_back(read.text(item));
               }}),
      needing(KeyNeeds::ratio,
              {"equal", "true: one unit is as long on both axes", form::truth(), &Panel::equal}),
      range_key("x", "ends of the axis: [-5 mm, 5 mm]", &Panel::x),
      needing(KeyNeeds::up, range_key("y", "ends of the axis", &Panel::y)),
      label_key("x", "text at the axis, to which the unit is added", &Panel::x),
      needing(KeyNeeds::up, label_key("y", "text at the axis", &Panel::y)),
      needing(KeyNeeds::depth, label_key("z", "text at the axis", &Panel::z)),
      needing(KeyNeeds::color_bar, label_key("color", "text at the colour bar", &Panel::color)),
      needing(KeyNeeds::depth, range_key("z", "ends of the axis", &Panel::z)),
      needing(KeyNeeds::color_bar,
              range_key("color", "values at both ends of the colour bar", &Panel::color)),
      needing(KeyNeeds::scale, {"log", "axes with a logarithmic scale: x, y, color, or a list",
                                form::one_or_list(form::word({"x", "y", "color"})), read_log}),
      own_key("boundary",
              "expression of x and y in SI units (or a list); a line is drawn where it is zero: x - 5 mm. "
              "What is recorded stands for its value in the first row that 'where' selects",
              form::one_or_list(form::signal()), read_boundaries, KeyNeeds::plane, KeyStage::rows),
      own_key("note",
              "expression whose value in the first row that 'where' selects is shown in a corner: {signal: "
              "normalised, label: error}",
              form::series(), read_note, KeyNeeds::nothing, KeyStage::rows),
      own_key("region", "name of a Region (or a list): its boundary is drawn, and its inside shaded",
              form::one_or_list(form::block()), read_regions, KeyNeeds::outlines),
      needing(KeyNeeds::outlines, {"region_line", "how the boundary of a region is drawn: line or dashes",
                                   form::word({"line", "dashes"}), &Panel::dashed_regions}),
      own_key("marks", "points with names, drawn on top: {A: [0 mm, 20 mm]}; a list of points numbers them",
              form::either({form::names(plane_point(), 1), form::list(plane_point())}), read_marks,
              KeyNeeds::both, KeyStage::points),
      own_key("texts", "texts in the plane, each about its point: {authorized region: [0 mm, 200 mm]}",
              form::names(plane_point(), 1), read_texts, KeyNeeds::both, KeyStage::points),
      own_key("motion",
              "the way of a point (or a list), drawn as a line with arrow heads: {x: hand.1, y: hand.2, "
              "where: time < 2 s, heads: 8, color: red}",
              form::one_or_list(motion_form()), read_motions, KeyNeeds::both),
      own_key("rose",
              "what happens at a point in each direction (or a list), drawn as a disc with spokes as long "
              "as `value`: {x: at.1, y: at.2, angle: phi, value: force in N, where: time > 1 s, at: [5 mm, "
              "0 mm], radius: 4 mm, name: D2}",
              form::one_or_list(rose_form()), read_roses, KeyNeeds::both)};
  return keys;
}

const std::vector<yaml::KeyRow<Figure, query::NamesReading>>& picture_keys() {
  static const std::vector<yaml::KeyRow<Figure, query::NamesReading>> keys{
      {"title", "text above the picture", form::text(), &Figure::title},
      {"caption", "text below the picture on the gallery page", form::text(), &Figure::caption},
      {"own", "true: the source has no such picture; the gallery says so", form::truth(), &Figure::own},
      {"size", "width and height in pixels: [640, 420]", form::pair(form::whole(80, 4000)), read_size},
      {"panels", "list of panels in one picture", form::list(form::section("panel"), 1)},
      yaml::otherwise("", yaml::KeyRow<Figure, query::NamesReading>{
                              "columns", "how many panels stand side by side; two where it is not given",
                              form::whole(1, 6), &Figure::columns})};
  return keys;
}

yaml::Key plot_form(const PlotKind& kind, bool alone) {
  std::vector<yaml::Key> keys{yaml::needed(key("plot", "kind of plot", form::word({kind.name})))};
  for (const Channel& channel : kind.channels) keys.push_back(channel_key(channel));
  add(kind.options, keys);
  if (!kind.read) add(keys_of_axes(kind), keys);
  std::vector<yaml::Key> picture = own_picture_keys();
  if (kind.read)
    std::erase_if(picture, [](const yaml::Key& key) { return key.name == "size" || key.name == "columns"; });
  if (alone) add(picture, keys);
  return key(kind.name, kind.doc,
             form::keys(fmt::format("a plot '{}'", kind.name), figure_example, std::move(keys)));
}

std::vector<yaml::Key> plot_forms(bool alone) {
  std::vector<yaml::Key> forms;
  for (const PlotKind& kind : plot_kinds())
    if (alone || !kind.read) forms.push_back(plot_form(kind, alone));
  return forms;
}

const yaml::Key& picture_form() {
  static const yaml::Key form = [] {
    yaml::Key keys = yaml::keys_form("a figure with panels", "{panels: [{plot: lines, x: time, y: rig.x}]}",
                                     picture_keys());
    for (yaml::Key& key : keys.of) key.required = key.name == "panels";
    return keys;
  }();
  return form;
}

const yaml::Key& figure_form() {
  static const yaml::Key form = [] {
    std::vector<yaml::Key::Word> kinds;
    for (const PlotKind& kind : plot_kinds()) kinds.push_back({kind.name, kind.doc});
    std::vector<yaml::Key> keys{
        yaml::needed(key("plot", "kind of plot, or `panels` in its place", form::words(std::move(kinds))))};
    add(panel_keys(), keys);
    add(picture_keys(), keys);
    return form::keys("a figure", figure_example, std::move(keys));
  }();
  return form;
}

}  // namespace stepwire::plot
