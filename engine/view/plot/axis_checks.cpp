#include <fmt/format.h>

#include <algorithm>

#include "engine/base/yaml/message.hpp"
#include "engine/view/plot/along_axis.hpp"
#include "engine/view/plot/panel_reading.hpp"

namespace stepwire::plot {
namespace {

/// Checks that all quantities along an axis are compatible; collects faults.
class AxisChecks {
 public:
  AxisChecks(Panel& panel, const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults)
      : panel_(panel), node_(node), names_(names), faults_(faults) {}

  void check() {
    for (const char* axis : {"x", "y"}) check_units(axis);
    check_arrows();
    const auto y = panel_.series.find("y");
    if (y == panel_.series.end()) return;
    check_number_of_x(y->second);
    for (const char* key : {"reference", "low", "high"}) check_along(key, y->second.front());
    check_legend(y->second);
  }

 private:
  void fault(yaml::Mark mark, const std::string& key, yaml::Message message) {
    faults_.add({{names_.file, mark}, "figure." + key, std::move(message), {}});
  }

  void check_units(const std::string& axis) {
    const auto found = panel_.series.find(axis);
    if (found == panel_.series.end()) return;
    const auto with_unit = std::ranges::find_if(found->second, has_unit);
    if (with_unit == found->second.end()) return;
    for (query::Series& series : found->second) {
      if (&series == &*with_unit) continue;
      const bool alike = series.unit_text == with_unit->unit_text;
      if (is_bare(series))
        series.unit = with_unit->unit;
      else if (series.unit_text.empty())
        fault(series.formula.mark, axis, no_unit(series, *with_unit));
      else if (!alike)
        fault(series.formula.mark, axis, two_units(series, *with_unit));
      else if (auto wrong = fault_along(series, *with_unit))
        fault(series.formula.mark, axis, std::move(*wrong));
    }
  }

  void check_number_of_x(const std::vector<query::Series>& y) {
    const auto x = panel_.series.find("x");
    if (x == panel_.series.end() || x->second.size() == 1 || x->second.size() == y.size()) return;
    fault(x->second.front().formula.mark, "x",
          fmt::format("there are {} in 'x' and {} in 'y'; x is one, or one for each y", x->second.size(),
                      y.size()));
  }

  /// Checks the two parts of the arrows of a field, of which both are drawn in the unit of the first. In a
  /// phase portrait, whose axes have two units, the parts have two as well.
  void check_arrows() {
    const query::Series *across = panel_.find("u"), *up = panel_.find("v");
    const query::Series *x = panel_.find("x"), *y = panel_.find("y");
    if (!across || !up || (x && y && x->formula.dimension != y->formula.dimension)) return;
    const auto &first = across->formula.dimension, &second = up->formula.dimension;
    if (!first || !second || *first == *second) return check_along("v", *across);
    fault(up->formula.mark, "v",
          yaml::fault_text("'{}' is in {}, but '{}' in {}; the two parts of an arrow have one unit",
                           across->formula.text, unit::si_name(*first), up->formula.text,
                           unit::si_name(*second)));
  }

  /// Checks the channels drawn along the axis of another channel, and gives them its unit.
  void check_along(const std::string& key, const query::Series& axis) {
    const auto found = panel_.series.find(key);
    if (found == panel_.series.end()) return;
    for (query::Series& series : found->second) {
      if (auto wrong = fault_along(series, axis)) fault(series.formula.mark, key, std::move(*wrong));
      series.unit = axis.unit;
      series.unit_text = axis.unit_text;
    }
  }

  /// Checks the legend. Without `by` there is one curve for each y, for any number of runs.
  void check_legend(const std::vector<query::Series>& y) {
    if (panel_.series.contains("by") || panel_.legend.size() <= y.size()) return;
    fault(node_.find("legend")->mark, "legend",
          fmt::format("there are {} texts, but only {} in 'y'; 'by' with a swept parameter tells runs apart",
                      panel_.legend.size(), y.size()));
  }

  Panel& panel_;
  const yaml::Node& node_;
  const query::SymbolTable& names_;
  yaml::Faults& faults_;
};

}  // namespace

void check_axes(Panel& panel, const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  AxisChecks(panel, node, names, faults).check();
}

}  // namespace stepwire::plot
