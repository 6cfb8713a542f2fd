#include <CLI/CLI.hpp>
#include <memory>
#include <thread>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/language/language_server.hpp"
#include "engine/app/language/message_frames.hpp"

namespace stepwire::cli {

namespace {

/// Passes all messages of the standard input to the server.
void read_messages(language::LanguageServer& server) {
  language::FrameReader frames(read_standard_input);
  try {
    while (auto message = frames.next()) server.post(std::move(*message));
  } catch (const language::FrameError& error) {
    complain("stepwire lsp: {}\n", error.what());
  }
  server.close();
}

ExitCode serve(const Registry& registry) {
  const auto server = std::make_shared<language::LanguageServer>(registry, [](const std::string& message) {
    put_data(language::framed(message));
    finish_output();
  });
  // An editor may end the server and keep the pipe open. So the thread that waits for input is detached.
  std::thread([server] { read_messages(*server); }).detach();
  return server->run() ? ExitCode::done : ExitCode::fails;
}

Action declare_lsp(CLI::App&) {
  return [](const Registry& registry) { return serve(registry); };
}

}  // namespace

Verb lsp_verb() {
  return {"lsp", "serve editors with what they show of diagram files, by the Language Server Protocol",
          "An editor starts it and talks to it over the standard input and output; see "
          "engine/app/language/README.md.",
          declare_lsp};
}

}  // namespace stepwire::cli
