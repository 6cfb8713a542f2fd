#pragma once

#include <string>
#include <vector>

#include "engine/model/diagram/scope.hpp"

namespace stepwire {

/// Reports every key of a map that is not among `known`, with the nearest one that is. Says whether there was
/// one: what is missing then may be what it was meant for.
bool refuse_unknown_keys(const Node& map, const std::vector<std::string>& known, const std::string& subject,
                         const Scope& scope, Report& report);

/// The text of a value that is for people or a word; "" and a fault where it is a list, a map or nothing.
std::string read_text(const Node& node, const std::string& subject, const Scope& scope, Report& report);

/// true or false; false and a fault where it is neither.
bool read_flag(const Node& node, const std::string& subject, const Scope& scope, Report& report);

/// Is this a name that a block, part, port or parameter may have? Letters, digits and '_', not beginning with
/// a digit.
bool is_name(const std::string& text);

/// Such names with dots between them: "rig.carriage".
bool is_dotted_name(const std::string& text);

}  // namespace stepwire
