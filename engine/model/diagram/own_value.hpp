#pragma once

#include <optional>
#include <string>

#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/variation.hpp"

namespace stepwire::diagram {

/// What a name is in a diagram; nothing where nothing has it.
std::optional<Variation::Name> find_name(const Diagram& diagram, const std::string& text);

/// The nearest name that something has, as the cure: "did you mean 'rig.mass'?"
yaml::Message nearest_name(const Diagram& diagram, const std::string& text);

/// The value that a diagram has of what a name stands for (a parameter, a value or an initial value of a
/// block, a time or the method of the file itself), as a setting of that name writes it; nothing where no
/// setting could: a default that is not finite, a solver that the file does not name.
std::optional<std::string> own_value(const Diagram& diagram, const Variation::Name& name);

}  // namespace stepwire::diagram
