#pragma once

#include <string>
#include <vector>

#include "engine/diagram/scope.hpp"

namespace stepwire {

/// Reports every key of a map that is not among `known`, with the nearest one that is.
void refuse_unknown_keys(const Node& map, const std::vector<std::string>& known, const std::string& subject,
                         const Scope& scope, Report& report);

/// Is this a name that a block, part, port or parameter may have? Letters, digits and '_', not beginning with
/// a digit.
bool is_name(const std::string& text);

/// Such names with dots between them: "rig.carriage".
bool is_dotted_name(const std::string& text);

}  // namespace stepwire
