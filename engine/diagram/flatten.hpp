#pragma once

#include <string>

#include "engine/diagram/diagram.hpp"

namespace stepwire {

/// All that decides what a diagram computes, as text: head, blocks with every parameter (to the last bit) and
/// source, record. The same for two files that differ only in layout, names of files, or parts opened by
/// hand.
std::string flattened_text(const Diagram& diagram);

/// Hash of that text, 16 hexadecimal digits (FNV-1a, 64 bits).
std::string diagram_hash(const Diagram& diagram);

}  // namespace stepwire
