#include "engine/view/plot/panel_reading.hpp"

namespace stepwire {
namespace {

/// The names of the panel's plane: x and y are its coordinates, whatever is recorded under these names.
Names plane_of(const Names& names) {
  Names plane = names;
  std::erase_if(plane.columns, [](const RecordedName& one) { return one.name == "x" || one.name == "y"; });
  plane.columns.insert(plane.columns.begin(), {{"x", {}, {}}, {"y", {}, {}}});
  plane.signals.clear();
  plane.unknown = "is no coordinate of the plane, nor recorded";
  return plane;
}

/// The recording that has what a formula and the panel's `where` name.
std::size_t recording_of(const Formula& formula, const Panel& panel, const Node& node, const Names& names,
                         const std::string& subject, Faults& faults) {
  return common_recording({panel.where ? &*panel.where : nullptr, &formula}, names, node, subject, faults);
}

}  // namespace

void read_boundaries(const Node& node, Panel& panel, const Names& names, Faults& faults) {
  const std::string subject = "figure.boundary";
  const Names plane = plane_of(names);
  for (const Node& item : items_of(node)) {
    auto formula = read_formula(item, plane, subject, faults);
    if (!formula) continue;
    formula->recording = recording_of(*formula, panel, item, plane, subject, faults);
    panel.boundaries.push_back(std::move(*formula));
  }
}

void read_note(const Node& node, Panel& panel, const Names& names, Faults& faults) {
  auto series = read_series(node, names, "figure.note", faults);
  if (!series) return;
  series->formula.recording = recording_of(series->formula, panel, node, names, "figure.note", faults);
  panel.series["note"] = {std::move(*series)};
}

}  // namespace stepwire
