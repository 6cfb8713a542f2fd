#include "engine/view/plot/panel_reading.hpp"

namespace stepwire::plot {
namespace {

/// Returns the names of the panel's plane: x and y are its coordinates, even if columns of these names are
/// recorded.
query::SymbolTable plane_of(const query::SymbolTable& names) {
  query::SymbolTable plane = names;
  std::erase_if(plane.columns,
                [](const query::RecordedName& one) { return one.name == "x" || one.name == "y"; });
  plane.columns.insert(plane.columns.begin(), {{"x", {}, {}}, {"y", {}, {}}});
  plane.signals.clear();
  plane.unknown = "is no coordinate of the plane, nor recorded";
  return plane;
}

/// Returns the recording with the columns of a formula and of the panel's `where`.
std::size_t recording_of(const query::Formula& formula, const Panel& panel, const yaml::Node& node,
                         const query::NamesReading& read) {
  return query::common_recording({panel.where ? &*panel.where : nullptr, &formula}, read.names, node,
                                 read.subject, read.faults);
}

}  // namespace

void read_boundaries(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  const query::SymbolTable names = plane_of(read.names);
  const query::NamesReading plane(read.subject, names, read.faults);
  for (const yaml::Node& item : node.as_list()) {
    auto formula = plane.formula(item);
    if (!formula) continue;
    formula->recording = recording_of(*formula, panel, item, plane);
    panel.boundaries.push_back(std::move(*formula));
  }
}

void read_note(const yaml::Node& node, Panel& panel, const query::NamesReading& read) {
  auto series = read.series(node);
  if (!series) return;
  series->formula.recording = recording_of(series->formula, panel, node, read);
  panel.series["note"] = {std::move(*series)};
}

}  // namespace stepwire::plot
