#pragma once

#include <optional>

#include "engine/analyse/query/series.hpp"
#include "engine/base/yaml/message.hpp"

namespace stepwire::plot {

/// True for a series with a unit other than 1.
bool has_unit(const query::Series& series);

/// True for a plain number, which has the SI unit of its counterpart.
bool is_bare(const query::Series& series);

/// Returns the fault of a series drawn along the axis of another one: a unit of another quantity, an unknown
/// unit, a rate or temperature of another meaning. Returns std::nullopt if it can be drawn in that unit.
std::optional<yaml::Message> fault_along(const query::Series& series, const query::Series& axis);

/// Returns the fault of two series in different units along one axis.
yaml::Message two_units(const query::Series& series, const query::Series& axis);
/// Returns the fault of a series of unknown unit beside one with a unit.
yaml::Message no_unit(const query::Series& series, const query::Series& axis);

}  // namespace stepwire::plot
