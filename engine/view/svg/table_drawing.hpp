#pragma once

#include <string>

#include "engine/base/text/text_table.hpp"

namespace stepwire::svg {

/// Returns the table as SVG.
std::string draw(const text::TextTable& table);

}  // namespace stepwire::svg
