#pragma once

#include <string>

#include "engine/base/yaml/message.hpp"

namespace stepwire::diagram {

/// Returns the message about a quoted number in the place of a number.
inline yaml::Message quoted_number(const std::string& text) {
  return yaml::fault_text("'{}' is text because of its quotes; leave them out for a number", text);
}

/// Returns "; a number with its unit is written '50 1/s'" for "50/s", which is read as a formula; empty for
/// other texts.
std::string quantity_cure(const std::string& text);

}  // namespace stepwire::diagram
