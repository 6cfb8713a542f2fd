#pragma once

#include <string>

#include "engine/base/text/text_table.hpp"

namespace stepwire {

/// The table as SVG.
std::string draw(const TextTable& table);

}  // namespace stepwire
