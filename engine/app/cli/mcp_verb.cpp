#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <thread>

#include "engine/app/cli/call_words.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/mcp/mcp_server.hpp"
#include "engine/app/session/version.hpp"

namespace stepwire::cli {

namespace {

ExitCode serve(const CLI::App& program, const std::string& root) {
  mcp::Host host{std::filesystem::read_symlink("/proc/self/exe").string(), root};
  const auto server =
      std::make_shared<mcp::McpServer>(mcp::tools_of(verb_words(program)), std::move(host),
                                       session::program_version(), [](const std::string& message) {
                                         put_data(message + "\n");
                                         finish_output();
                                       });
  std::thread reader([server] {
    mcp::LineReader lines(read_standard_input);
    while (auto line = lines.next()) server->post(std::move(*line));
    server->close();
  });
  server->run();
  reader.join();
  return ExitCode::done;
}

Action declare_mcp(CLI::App& verb) {
  const auto root = std::make_shared<std::string>("/");
  verb.add_option("--root", *root, "folder below which the folders of calls are; / without it")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  return [root, program = verb.get_parent()](const Registry&) { return serve(*program, *root); };
}

}  // namespace

Verb mcp_verb() {
  return {"mcp", "serve programs with the verbs as tools, by the Model Context Protocol",
          "A program starts it and talks to it over the standard input and output, one message a line; see "
          "diagrams/for-programs.md.",
          declare_mcp};
}

}  // namespace stepwire::cli
