#include <fmt/format.h>

#include "engine/app/cli/commands.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/reference/block_json.hpp"
#include "engine/app/reference/block_markdown.hpp"
#include "engine/app/reference/block_page.hpp"
#include "engine/app/reference/diagram_schema.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire {

namespace {

std::string one_block(const BlocksCommand& command, const BlockType& type) {
  if (command.json) return block_json(type).text() + "\n";
  return command.markdown ? block_markdown(type) : block_page(type);
}

std::string all_of(const BlocksCommand& command, const Registry& registry) {
  if (command.json) return blocks_json(registry).text() + "\n";
  return command.markdown ? blocks_markdown(registry) : block_list(registry);
}

}  // namespace

ExitCode show_blocks(const BlocksCommand& command, const Registry& registry) {
  if (command.name.empty()) {
    put_data(all_of(command, registry));
    return ExitCode::done;
  }
  const BlockType* type = registry.find(command.name);
  if (!type) {
    complain("there is no block '{}'{}\n", visible(command.name),
             did_you_mean(command.name, registry.names(), "'stepwire blocks' lists them"));
    return ExitCode::wrong;
  }
  put_data(one_block(command, *type));
  return ExitCode::done;
}

ExitCode show_schema(const Registry& registry) {
  say("{}\n", diagram_schema(registry).text());
  return ExitCode::done;
}

}  // namespace stepwire
