#include "engine/view/plot/figure.hpp"

#include <algorithm>

#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/panel_reading.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire {
namespace {

void read_panels(const Node& node, Figure& figure, const Names& names, Faults& faults) {
  std::vector<std::string> known;
  for (const FigureKey& key : picture_keys()) known.push_back(key.name);
  for (const auto& entry : node.entries)
    if (std::find(known.begin(), known.end(), entry.key) == known.end())
      add_unknown_key(entry, known, "a figure with panels", names, "figure", faults);
  const Node& panels = *node.find("panels");
  if (!panels.is_list() || panels.items.empty()) {
    faults.add({{names.file, panels.mark}, "figure.panels", "panels are a list of plots", {}});
    return;
  }
  for (const auto& item : panels.items)
    if (auto panel = read_panel(item, names, false, faults)) figure.panels.push_back(std::move(*panel));
  figure.columns = std::min<int>(2, static_cast<int>(panels.items.size()));
}

Figure read_figure(const Node& node, const Names& names, Faults& faults) {
  Figure figure;
  const bool several = node.is_map() && node.find("panels") != nullptr;
  if (several)
    read_panels(node, figure, names, faults);
  else if (auto panel = read_panel(node, names, true, faults))
    figure.panels.push_back(std::move(*panel));
  for (const auto& key : picture_keys())
    if (const Node* value = node.find(key.name); value && key.set) key.set(figure, *value, {names, faults});
  return figure;
}

}  // namespace

const Series* Panel::find(const std::string& key) const {
  const auto found = series.find(key);
  return found == series.end() || found->second.empty() ? nullptr : &found->second.front();
}

const AxisOptions& Panel::axis(std::string_view name) const {
  static const AxisOptions none;
  return name == "x" ? x : name == "y" ? y : name == "z" ? z : name == "color" ? color : none;
}

std::vector<Figure> read_figures(const Node& node, const Names& names, Faults& faults) {
  std::vector<Figure> figures;
  for (const Node& item : items_of(node)) figures.push_back(read_figure(item, names, faults));
  return figures;
}

std::vector<FigureKey> plot_names() {
  std::vector<FigureKey> names;
  for (const auto& kind : plot_kinds()) names.push_back({kind.name, kind.doc});
  return names;
}

std::vector<FigureKey> figure_keys(const std::string& plot) {
  std::vector<FigureKey> keys;
  for (const auto& kind : plot_kinds()) {
    if (kind.name != plot) continue;
    for (const auto& channel : kind.channels) keys.push_back({channel.key, channel.doc});
    for (const FigureKey& option : kind.options) keys.push_back(option);
  }
  if (!plot.empty()) return keys;
  for (const FigureKey& key : panel_keys()) keys.push_back(key);
  for (const FigureKey& key : picture_keys())
    if (key.name != "title") keys.push_back(key);
  return keys;
}

}  // namespace stepwire
