#pragma once

#include <optional>
#include <string>

#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/variation.hpp"

namespace stepwire::diagram {

/// Finds a name in a diagram; std::nullopt if it does not exist.
std::optional<Variation::Name> find_name(const Diagram& diagram, const std::string& text);

/// Returns the nearest existing name as the cure: "did you mean 'rig.mass'?".
yaml::Message nearest_name(const Diagram& diagram, const std::string& text);

/// Returns the value of a name in a diagram as the text of a setting. The name is a parameter, a value or
/// initial value of a block, or a time or method of the file itself. Returns std::nullopt if no setting could
/// express the value: a default that is not finite, or a solver that the file does not name.
std::optional<std::string> own_value(const Diagram& diagram, const Variation::Name& name);

}  // namespace stepwire::diagram
