#pragma once

#include <string>
#include <vector>

#include "engine/base/fmi/model.hpp"
#include "engine/base/yaml/message.hpp"

namespace stepwire::fmi {

/// Result of reading an assignment: the assignment, or a fault in `wrong`.
struct ReadAssignment {
  Assignment assignment{};
  yaml::Message wrong{};
};

/// Parses `name: values` ("2 1/s" for a number) and checks unit, type and limits of the variable. The fault
/// for an unknown name suggests the nearest settable one.
ReadAssignment read_assignment(const Description& description, const std::string& name,
                               const std::vector<std::string>& values);

}  // namespace stepwire::fmi
