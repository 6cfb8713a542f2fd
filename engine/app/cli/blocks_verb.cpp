#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/reference/block_json.hpp"
#include "engine/app/reference/block_markdown.hpp"
#include "engine/app/reference/block_page.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {

namespace {

struct BlocksCall {
  std::string name;
  bool json = false;
  bool markdown = false;
};

std::string one_block(const BlocksCall& call, const BlockType& type) {
  if (call.json) return reference::block_json(type).text() + "\n";
  return call.markdown ? reference::block_markdown(type) : reference::block_page(type);
}

std::string all_of(const BlocksCall& call, const Registry& registry) {
  if (call.json) return reference::blocks_json(registry).text() + "\n";
  return call.markdown ? reference::blocks_markdown(registry) : reference::block_list(registry);
}

ExitCode show_blocks(const BlocksCall& call, const Registry& registry) {
  if (call.name.empty()) {
    put_data(all_of(call, registry));
    return ExitCode::done;
  }
  const BlockType* type = registry.find(call.name);
  if (!type) {
    complain("there is no block '{}'{}\n", text::visible(call.name),
             yaml::did_you_mean(call.name, registry.names(), "'stepwire blocks' lists them").text());
    return ExitCode::wrong;
  }
  put_data(one_block(call, *type));
  return ExitCode::done;
}

Action declare_blocks(CLI::App& verb) {
  const auto call = std::make_shared<BlocksCall>();
  verb.add_option("NAME", call->name, "a block");
  verb.add_flag("--json", call->json, "as JSON");
  verb.add_flag("--markdown", call->markdown, "as Markdown");
  return [call](const Registry& registry) { return show_blocks(*call, registry); };
}

}  // namespace

Verb blocks_verb() {
  return {"blocks", "list the blocks, or explain one",
          "Example:\n  stepwire blocks PID\n  stepwire blocks --markdown > blocks.md", declare_blocks};
}

}  // namespace stepwire::cli
