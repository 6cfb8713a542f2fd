#pragma once

#include <stop_token>
#include <string>

#include "engine/app/mcp/tool.hpp"

namespace stepwire::mcp {

/// Program that runs the verbs, and the folder below which those of calls are.
struct Host {
  std::string program;
  std::string root = "/";
};

/// Calls a verb in a process of its own and returns the result of `tools/call`. It has a short text, and the
/// data as `structuredContent` and as text. isError is set if the verb found a fault or was ended. A stop
/// request ends the process.
json::Json call_tool(const Tool& tool, const json::Json& arguments, const Host& host, std::stop_token stop);

}  // namespace stepwire::mcp
