#include "engine/view/plot/along_axis.hpp"

#include <fmt/format.h>

#include "engine/base/unit/meaning.hpp"

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
         (unit::is_temperature(theirs) ? "give it a panel of its own" : unit::cure_of_rate(theirs));
}

}  // namespace

bool has_unit(const query::Series& series) {
  return !series.unit_text.empty() && series.unit_text != "1";
}

bool is_bare(const query::Series& series) {
  return series.unit_text.empty() && series.formula.columns.empty();
}

yaml::Message two_units(const query::Series& series, const query::Series& axis) {
  return yaml::fault_text("'{}' is drawn in {}, but '{}' in {}; one axis has one unit: give each a panel",
                          axis.formula.text, axis.unit_text, series.formula.text, series.unit_text);
}

yaml::Message no_unit(const query::Series& series, const query::Series& axis) {
  return yaml::fault_text(
      "'{}' is drawn in {}, but the unit of '{}' is not known; {}", axis.formula.text, axis.unit_text,
      series.formula.text,
      query::unit_cure(series.formula, axis.formula.dimension.value_or(axis.unit.dimension)));
}

std::optional<yaml::Message> fault_along(const query::Series& series, const query::Series& axis) {
  if (is_bare(series) || is_bare(axis)) return std::nullopt;
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

}  // namespace stepwire::plot
