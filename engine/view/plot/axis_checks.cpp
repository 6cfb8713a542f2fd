#include <fmt/format.h>

#include <algorithm>

#include "engine/view/plot/panel_reading.hpp"

#include "engine/base/yaml/message.hpp"

namespace stepwire::plot {
namespace {

/// Checks that all quantities along an axis are compatible; collects faults.
class AxisChecks {
 public:
  AxisChecks(Panel& panel, const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults)
      : panel_(panel), node_(node), names_(names), faults_(faults) {}

  void check() {
    for (const char* axis : {"x", "y"}) check_units(axis);
    const auto y = panel_.series.find("y");
    if (y == panel_.series.end()) return;
    check_number_of_x(y->second);
    check_references(y->second.front());
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
      if (&series == &*with_unit || series.unit_text == with_unit->unit_text) continue;
      if (is_bare(series))
        series.unit = with_unit->unit;
      else if (series.unit_text.empty())
        no_unit(axis, series, *with_unit);
      else
        two_units(axis, series, *with_unit);
    }
  }

  static bool has_unit(const query::Series& series) {
    return !series.unit_text.empty() && series.unit_text != "1";
  }

  /// True for a plain number, which has the SI unit of its counterpart.
  static bool is_bare(const query::Series& series) {
    return series.unit_text.empty() && series.formula.columns.empty();
  }

  void check_number_of_x(const std::vector<query::Series>& y) {
    const auto x = panel_.series.find("x");
    if (x == panel_.series.end() || x->second.size() == 1 || x->second.size() == y.size()) return;
    fault(x->second.front().formula.mark, "x",
          fmt::format("there are {} in 'x' and {} in 'y'; x is one, or one for each y", x->second.size(),
                      y.size()));
  }

  void check_references(const query::Series& first) {
    const auto references = panel_.series.find("reference");
    if (references == panel_.series.end()) return;
    for (query::Series& reference : references->second) {
      const auto &ours = reference.formula.dimension, &axis = first.formula.dimension;
      if (ours && axis && *ours != *axis) two_units("reference", reference, first);
      if (!is_bare(reference) && has_unit(first) && reference.unit_text.empty())
        no_unit("reference", reference, first);
      reference.unit = first.unit;
    }
  }

  void no_unit(const std::string& key, const query::Series& series, const query::Series& first) {
    fault(series.formula.mark, key,
          yaml::fault_text(
              "'{}' is drawn in {}, but the unit of '{}' is not known; {}", first.formula.text,
              first.unit_text, series.formula.text,
              query::unit_cure(series.formula, first.formula.dimension.value_or(first.unit.dimension))));
  }

  void two_units(const std::string& key, const query::Series& series, const query::Series& first) {
    fault(series.formula.mark, key,
          yaml::fault_text("'{}' is drawn in {}, but '{}' in {}; one axis has one unit: give each a panel",
                           first.formula.text, first.unit_text, series.formula.text, series.unit_text));
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
