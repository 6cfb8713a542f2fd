#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/mcp/tool.hpp"
#include "engine/app/mcp/tool_folder.hpp"

namespace stepwire::mcp {

/// Call of a verb that the arguments of a tool give.
struct VerbCall {
  std::vector<std::string> words;  ///< verb, positional arguments and options
  std::chrono::milliseconds limit{60'000};
  std::size_t rows = 0;  ///< rows of recorded signals to return; 0: none
  std::string out;       ///< value of `out`; empty without it
};

/// Converts arguments to the call of a verb, and writes texts into the folder. Throws CallFault for unknown
/// and missing arguments, values of another type, and paths that lead out of the folder.
VerbCall verb_call(const Tool& tool, const json::Json& arguments, ToolFolder& folder);

}  // namespace stepwire::mcp
