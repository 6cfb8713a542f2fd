#include <fmt/format.h>

#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/panel_reading.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {
namespace {

const query::NamedOutline* find_outline(const yaml::Node& node, const query::NamesReading& read) {
  std::vector<std::string> names;
  for (const query::NamedOutline& named : read.names.outlines) {
    if (node.is_scalar() && named.name == node.text) return &named;
    names.push_back(named.name);
  }
  const yaml::Message choice =
      names.empty() ? "; this file has none" : yaml::nearest_or_all(node.text, names, "there are");
  read.fault(node.mark, fmt::format("'{}' is no block with a boundary, as a Region is", node.text) + choice);
  return nullptr;
}

}  // namespace

void read_regions(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  for (const yaml::Node& item : node.as_list()) {
    const query::NamedOutline* found = find_outline(item, read);
    if (!found) continue;
    const bool space = found->outline.space;
    if (space == panel.kind->plane)
      read.fault(item.mark,
                 fmt::format("'{}' lies in {}, and a plot '{}' shows {}", item.text,
                             space ? "space" : "the plane", panel.kind->name, space ? "the plane" : "space"));
    panel.regions.push_back(*found);
  }
}

}  // namespace stepwire::plot
