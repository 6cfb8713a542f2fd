#include <fmt/format.h>

#include "engine/app/cli/commands.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/base/io/file.hpp"
#include "engine/view/drawing/graph_faults.hpp"

namespace stepwire {

namespace {

void require_names(const DrawCommand& command, const DiagramView& view) {
  Faults faults;
  for (const GraphFault& fault : faults_of(view, command.options))
    faults.add({{command.file, {}}, "", fault.message, {}});
  faults.throw_if_any();
}

}  // namespace

ExitCode draw_file(const DrawCommand& command, const Registry& registry) {
  Loader loader(registry);
  const DrawnFile file(loader, command.file);
  require_names(command, file.view());
  const EndDelay delay(EndDelay::Signals::first);
  const Json graph = file.view().graph(command.options);
  const std::string text = command.json ? graph.text() + "\n" : draw_picture(graph);
  if (command.out.empty()) {
    put_data(text);
  } else {
    write_file(command.out, text);
  }
  return ExitCode::done;
}

}  // namespace stepwire
