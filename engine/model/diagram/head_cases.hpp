#pragma once

#include <string>

#include "engine/model/diagram/diagram.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// A swept value as a setting writes it.
std::string setting_text(const yaml::Node& node);

/// The file's own value of what an axis sets, as a setting writes it. Where there is none, a fault of
/// `subject` and an empty text.
std::string base_value(const Sweep::Axis& axis, const std::string& subject, Report& report);

/// Reads the key `cases` of a sweep, {NO: {}, H: {haptic: 1}}: an axis for each parameter that a case sets,
/// and a label with the names of the cases.
void read_cases(const yaml::Node& cases, const Scope& scope, Sweep& sweep, Report& report);

}  // namespace stepwire::diagram
