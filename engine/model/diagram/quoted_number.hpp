#pragma once

#include <string>

#include "engine/base/yaml/message.hpp"

namespace stepwire::diagram {

/// Returns the message about a quoted number in the place of a number.
inline yaml::Message quoted_number(const std::string& text) {
  return yaml::fault_text("'{}' is text because of its quotes; leave them out for a number", text);
}

}  // namespace stepwire::diagram
