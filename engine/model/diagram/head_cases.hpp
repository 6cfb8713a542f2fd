#pragma once

#include <string>

#include "engine/model/diagram/diagram.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// Returns a swept value as the text of a setting.
std::string setting_text(const yaml::Node& node);

/// Returns the file's own value for an axis as the text of a setting. Without one it adds a fault of
/// `subject` and returns an empty text.
std::string base_value(const Sweep::Axis& axis, const std::string& subject, Report& report);

/// Reads the key `cases` of a sweep, {NO: {}, H: {haptic: 1}}: an axis for each parameter that a case sets,
/// and a label with the names of the cases.
void read_cases(const yaml::Node& cases, const Scope& scope, Sweep& sweep, Report& report);

}  // namespace stepwire::diagram
