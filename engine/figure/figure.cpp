#include "engine/figure/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/number.hpp"
#include "engine/figure/panel_reading.hpp"
#include "engine/figure/plot_kind.hpp"

namespace stepwire {
namespace {

/// A whole number between two limits, or a fault.
int read_count(const Node& node, int low, int high, const std::string& subject, const Names& names,
               Faults& faults) {
  const auto number = read_number(node, names, subject, faults);
  if (!number) return low;
  if (number->value >= low && number->value <= high && number->value == std::floor(number->value))
    return static_cast<int>(number->value);
  faults.add(
      {{names.file, node.mark},
       subject,
       fmt::format("{} is not allowed; it must be a whole number from {} to {}", number->text, low, high),
       {}});
  return low;
}

bool read_bool(const Node& node, const std::string& subject, const Names& names, Faults& faults) {
  if (node.text != "true" && node.text != "false")
    faults.add(
        {{names.file, node.mark}, subject, fmt::format("'{}' is neither true nor false", node.text), {}});
  return node.text == "true";
}

void read_size(const Node& node, Figure& figure, const Names& names, Faults& faults) {
  if (!node.is_list() || node.items.size() != 2) {
    faults.add(
        {{names.file, node.mark}, "figure.size", "size takes width and height in pixels: [640, 420]", {}});
    return;
  }
  figure.width = read_count(node.items[0], 100, 4000, "figure.size", names, faults);
  figure.height = read_count(node.items[1], 80, 4000, "figure.size", names, faults);
}

void read_panels(const Node& node, Figure& figure, const Names& names, Faults& faults) {
  std::vector<std::string> known;
  for (const auto& key : picture_keys()) known.push_back(key.name);
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
  if (const Node* title = node.find("title")) figure.title = read_text(*title, names, "figure.title", faults);
  if (const Node* caption = node.find("caption"))
    figure.caption = read_text(*caption, names, "figure.caption", faults);
  if (const Node* own = node.find("own")) figure.own = read_bool(*own, "figure.own", names, faults);
  if (const Node* size = node.find("size")) read_size(*size, figure, names, faults);
  if (const Node* columns = node.find("columns"))
    figure.columns = read_count(*columns, 1, 6, "figure.columns", names, faults);
  return figure;
}

}  // namespace

const Series* Panel::find(const std::string& key) const {
  const auto found = series.find(key);
  return found == series.end() || found->second.empty() ? nullptr : &found->second.front();
}

std::vector<Figure> read_figures(const Node& node, const Names& names, Faults& faults) {
  std::vector<Figure> figures;
  const std::vector<Node> one{node};
  for (const auto& item : node.is_list() ? node.items : one)
    figures.push_back(read_figure(item, names, faults));
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
    for (const auto& option : kind.options) keys.push_back({option.key, option.doc});
  }
  if (!plot.empty()) return keys;
  keys = panel_keys();
  for (const auto& key : picture_keys())
    if (key.name != "title") keys.push_back(key);
  return keys;
}

}  // namespace stepwire
