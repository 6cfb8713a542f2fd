#pragma once

#include <string>

#include "engine/model/diagram/diagram.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// Most runs of a sweep: all are checked before the first one starts.
inline constexpr std::size_t max_runs = 10'000'000;

/// Reads {from: .., to: .., count: ..}; returns no values after a fault.
SweptValues read_range(const yaml::Node& map, const std::string& name, const Scope& scope, Report& report);

}  // namespace stepwire::diagram
