#include <fmt/format.h>

#include <filesystem>

#include "engine/app/cli/commands.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/base/io/file.hpp"
#include "engine/model/diagram/flatten.hpp"

namespace stepwire {

ExitCode flatten_file(const FlattenCommand& command, const Registry& registry) {
  std::error_code none;
  if (!command.out.empty() && std::filesystem::equivalent(command.file, command.out, none)) {
    complain("{} would be written over itself; give -o another name\n", command.file);
    return ExitCode::wrong;
  }
  Loader loader(registry, command.options.limits);
  const Plan plan = make_plan(loader.load(command.file, command.options.settings));
  const std::string text = flattened_text(plan.diagram);
  if (command.out.empty()) {
    put_data(text);
  } else {
    write_file(command.out, text);
  }
  return ExitCode::done;
}

}  // namespace stepwire
