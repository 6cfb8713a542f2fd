#pragma once

#include <string>
#include <vector>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::drawing {

/// Text of a block's symbol.
struct SymbolText {
  std::vector<std::string> lines;
  bool fraction = false;  ///< True for the first line over the second, with a bar between them.
};

/// Returns a value of a file in readable form: `2 N`, `τ` for `$tau`, `2·a` for `= 2*a`, `[1, 2]`.
std::string printed_value(const yaml::Node& node);

/// Returns the text of the block's symbol with its parameters filled in. A symbol with neither text nor curve
/// has the words of the type's name. `written` are the keys of the block in its file.
SymbolText symbol_text(const diagram::DiagramBlock& block, const yaml::Node& written);

/// Returns the sample time of a block as its file has it: "50 ms", "3 ms + 1 ms" with an offset. Empty
/// without one.
std::string sample_time_text(const diagram::DiagramBlock& block, const yaml::Node& written);

}  // namespace stepwire::drawing
