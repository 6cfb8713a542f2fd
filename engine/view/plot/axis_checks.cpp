#include "engine/view/plot/axis_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/number.hpp"
#include "engine/base/text/count.hpp"
#include "engine/base/unit/meaning.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/message.hpp"

namespace stepwire::plot {
namespace {

/// Returns the dimension of a series with its meaning, from its formula or else from the unit that it is
/// drawn in.
std::optional<unit::Dimension> drawn_dimension(const query::Series& series) {
  std::optional<unit::Dimension> own = series.formula.dimension;
  if (series.unit_text.empty()) return own;
  const auto named = unit::parse_unit(series.unit_text);
  const unit::Dimension& unit = named ? named->dimension : series.unit.dimension;
  if (!own) return unit;
  if (*own != unit) return own;
  if (!own->zeros) own->zeros = unit.zeros;
  if (own->angle == 0.0 && own->cycles == 0.0) {
    own->angle = unit.angle;
    own->cycles = unit.cycles;
  }
  return own;
}

/// Returns the fault of a value whose meaning is not that of the axis; empty if the meanings agree.
std::string other_meaning(const query::Series& series, const unit::Dimension& ours,
                          const unit::Dimension& theirs) {
  const bool is_number = series.formula.columns.empty();
  const std::string other =
      is_number ? unit::other_meaning_of_number(ours, theirs) : unit::other_meaning(ours, theirs);
  if (other.empty() || is_number) return other;
  return other + "; " +
         (unit::is_temperature(theirs) ? "give it a panel of its own" : unit::cure_of_rate(ours, theirs));
}

/// True for a series with a unit other than 1.
bool has_unit(const query::Series& series) {
  return !series.unit_text.empty() && series.unit_text != "1";
}

/// True for a number without unit, e.g. of a parameter. It has the SI unit of its counterpart.
bool is_bare(const query::Series& series) {
  return series.unit_text.empty() && series.formula.columns.empty();
}

/// Returns the fault of two series in different units along one axis.
yaml::Message two_units(const query::Series& series, const query::Series& axis) {
  const auto one = unit::parse_unit(series.unit_text), other = unit::parse_unit(axis.unit_text);
  const bool is_alike = one && other && one->dimension == other->dimension;
  const std::string cure =
      is_alike ? fmt::format("write '{} in {}'", series.formula.text, axis.unit_text) : "give each a panel";
  return yaml::fault_text("'{}' is drawn in {}, but '{}' in {}; one axis has one unit: {}", axis.formula.text,
                          axis.unit_text, series.formula.text, series.unit_text, cure);
}

/// Returns the fault of a series of unknown unit beside one with a unit.
yaml::Message no_unit(const query::Series& series, const query::Series& axis) {
  return yaml::fault_text(
      "'{}' is drawn in {}, but the unit of '{}' is not known; {}", axis.formula.text, axis.unit_text,
      series.formula.text,
      query::unit_cure(series.formula, axis.formula.dimension.value_or(axis.unit.dimension)));
}

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
      if (is_bare(series)) {
        if (auto wrong = bare_number(series.formula.text, *with_unit))
          fault(series.formula.mark, axis, std::move(*wrong));
        series.unit = with_unit->unit;
      } else if (series.unit_text.empty())
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
          fmt::format("{}, but only {} in 'y'; 'by' with a swept parameter tells runs apart",
                      text::there_are(panel_.legend.size(), "text"), y.size()));
  }

  Panel& panel_;
  const yaml::Node& node_;
  const query::SymbolTable& names_;
  yaml::Faults& faults_;
};

}  // namespace

std::optional<yaml::Message> bare_number(const std::string& text, const query::Series& axis) {
  return query::bare_number(text, axis.unit_text, fmt::format("'{}'", axis.formula.text));
}

std::optional<yaml::Message> fault_along(const query::Series& series, const query::Series& axis) {
  if (is_bare(series)) return bare_number(series.formula.text, axis);
  if (is_bare(axis)) return std::nullopt;
  const auto ours = drawn_dimension(series), theirs = drawn_dimension(axis);
  if (ours && theirs && *ours != *theirs) return two_units(series, axis);
  if (has_unit(axis) && !ours) return no_unit(series, axis);
  if (has_unit(series) && !theirs) return no_unit(axis, series);
  if (!ours || !theirs) return std::nullopt;
  std::string other = other_meaning(series, *ours, *theirs);
  if (!other.empty()) return fmt::format("'{}' {}", series.formula.text, other);
  other = other_meaning(axis, *theirs, *ours);
  if (other.empty()) return std::nullopt;
  return fmt::format("'{}' {}", axis.formula.text, other);
}

void check_axes(Panel& panel, const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  AxisChecks(panel, node, names, faults).check();
}

}  // namespace stepwire::plot
