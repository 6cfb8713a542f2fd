#include "engine/view/plot/figure.hpp"

#include <algorithm>

#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/panel_reading.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {
namespace {

/// Adds a panel. A Bode plot becomes two panels with a common frequency axis, and a Nyquist plot has equal
/// axes.
void add_panel(Panel panel, Figure& figure) {
  if (panel.kind->name == nyquist_plot().name) panel.equal = true;
  if (panel.kind->name != bode_plot().name) return figure.panels.push_back(std::move(panel));
  panel.x.log = true;
  figure.panels.push_back(panel);
  panel.kind = &bode_phase_plot();
  panel.title.clear();
  panel.y = {};
  panel.legend.clear();
  figure.panels.push_back(std::move(panel));
}

void read_panels(const yaml::Node& node, Figure& figure, const query::SymbolTable& names,
                 yaml::Faults& faults) {
  const query::NamesReading read("figure", names, faults);
  read.check(node, picture_form());
  const yaml::Node& panels = *node.find("panels");
  if (!panels.is_list() || panels.items.empty()) {
    faults.add({{names.file, panels.mark}, "figure.panels", "panels are a list of plots", {}});
    return;
  }
  for (const auto& item : panels.items)
    if (auto panel = read_panel(item, names, false, faults)) add_panel(std::move(*panel), figure);
  figure.columns = std::min<int>(2, static_cast<int>(panels.items.size()));
}

Figure read_figure(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  Figure figure;
  const bool several = node.is_map() && node.find("panels") != nullptr;
  if (several)
    read_panels(node, figure, names, faults);
  else if (auto panel = read_panel(node, names, true, faults))
    add_panel(std::move(*panel), figure);
  yaml::set_keys(node, picture_keys(), figure, query::NamesReading("figure", names, faults));
  return figure;
}

}  // namespace

const query::Series* Panel::find(const std::string& key) const {
  const auto found = series.find(key);
  return found == series.end() || found->second.empty() ? nullptr : &found->second.front();
}

const AxisOptions& Panel::axis(std::string_view name) const {
  static const AxisOptions none;
  return name == "x" ? x : name == "y" ? y : name == "z" ? z : name == "color" ? color : none;
}

std::vector<Figure> read_figures(const yaml::Node& node, const query::SymbolTable& names,
                                 yaml::Faults& faults) {
  std::vector<Figure> figures;
  for (const yaml::Node& item : node.as_list()) figures.push_back(read_figure(item, names, faults));
  return figures;
}

}  // namespace stepwire::plot
