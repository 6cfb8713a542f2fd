#include "engine/draw/draw.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/cli/commands.hpp"
#include "engine/table/file.hpp"

namespace stepwire {

namespace {

void require_parts(const DrawCommand& command, const std::vector<std::string>& parts) {
  Faults faults;
  for (const std::string& name : command.options.open) {
    if (std::find(parts.begin(), parts.end(), name) != parts.end()) continue;
    const std::string all =
        parts.empty() ? "It has no parts" : fmt::format("It has: {}", fmt::join(parts, ", "));
    faults.add({{command.file, {}},
                "",
                fmt::format("there is no part '{}'{}", name, did_you_mean(name, parts, all)),
                {}});
  }
  faults.throw_if_any();
}

}  // namespace

ExitCode draw_file(const DrawCommand& command, const Registry& registry) {
  Loader loader(registry);
  const DrawnFile file(loader, command.file);
  require_parts(command, file.view().parts());
  const Json graph = file.view().graph(command.options);
  const std::string text = command.json ? graph.text() + "\n" : draw_picture(graph);
  if (command.out.empty()) {
    fmt::print("{}", text);
  } else {
    write_file(command.out, text);
  }
  return ExitCode::done;
}

}  // namespace stepwire
