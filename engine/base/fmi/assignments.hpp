#pragma once

#include <string>
#include <vector>

#include "engine/base/fmi/model.hpp"
#include "engine/base/yaml/message.hpp"

namespace stepwire::fmi {

/// What a variable is to be: its value as text, with its unit. Either an assignment, or what is wrong.
struct ReadAssignment {
  Assignment assignment{};
  yaml::Message wrong{};
};

/// Reads `name: values`, "2 1/s" for a number, checked against the variable's unit, type and limits. Unknown
/// names are answered with the nearest one that may be set.
ReadAssignment read_assignment(const Description& description, const std::string& name,
                               const std::vector<std::string>& values);

}  // namespace stepwire::fmi
