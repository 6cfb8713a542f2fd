#include <fmt/format.h>

#include "engine/cli/commands.hpp"

namespace stepwire {

ExitCode show_blocks(const BlocksCommand& command, const Registry& registry) {
  for (const std::string& name : registry.names()) fmt::print("{}\n", name);
  return command.name.empty() ? ExitCode::done : ExitCode::wrong;
}

ExitCode show_schema(const Registry&) { return ExitCode::wrong; }

}  // namespace stepwire
