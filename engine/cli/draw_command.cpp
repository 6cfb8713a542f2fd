#include "engine/draw/draw.hpp"

#include <fmt/format.h>

#include "engine/cli/commands.hpp"
#include "engine/table/file.hpp"

namespace stepwire {

ExitCode draw_file(const DrawCommand& command, const Registry& registry) {
  Loader loader(registry);
  const DrawnFile file(loader, command.file);
  const Json graph = file.graph(command.options);
  const std::string text = command.json ? graph.text() + "\n" : draw_graph(graph);
  if (command.out.empty()) {
    fmt::print("{}", text);
  } else {
    write_file(command.out, text);
  }
  return ExitCode::done;
}

}  // namespace stepwire
