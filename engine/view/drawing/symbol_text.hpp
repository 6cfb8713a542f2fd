#pragma once

#include <string>
#include <vector>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::drawing {

/// What is written in a block's symbol.
struct SymbolText {
  std::vector<std::string> lines;
  bool fraction = false;  ///< the first line over the second, with a bar between them
};

/// A value of a file as one reads it: `2 N`, `τ` for `$tau`, `2·a` for `= 2*a`, `[1, 2]`.
std::string printed_value(const yaml::Node& node);

/// The text of the block's symbol with its parameters filled in; the words of the type's name where the
/// symbol has neither text nor curve. `written` are the keys of the block in its file.
SymbolText symbol_text(const diagram::DiagramBlock& block, const yaml::Node& written);

/// The sample time that a block has of its own, as its file writes it: "50 ms", "3 ms + 1 ms" with an offset.
/// Empty without one.
std::string sample_time_text(const diagram::DiagramBlock& block, const yaml::Node& written);

}  // namespace stepwire::drawing
