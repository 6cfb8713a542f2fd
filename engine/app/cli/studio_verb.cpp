#include <CLI/CLI.hpp>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <thread>

#include "engine/app/cli/call_options.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/studio/page_table.hpp"
#include "engine/app/studio/studio.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {
namespace {

struct StudioWords {
  std::string file, port, out;
  bool no_open = false, loop = false;
  session::LoopWords timing;
};

/// Parses a port; 0 means any free port. Throws Error.
std::uint16_t port_of(const std::string& text) {
  std::uint16_t port = 0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, port);
  if (error == std::errc() && read == end) return port;
  throw yaml::Error(yaml::Fault{
      {"--port " + text, {}}, "", "must be a whole number from 0 to 65535, where 0 is any free port", {}});
}

studio::StudioCall call_of(const StudioWords& words) {
  studio::StudioCall call{words.file};
  if (!words.port.empty()) call.port = port_of(words.port);
  call.out = words.out;
  if (words.loop) call.loop = session::read_loop_settings(words.timing);
  return call;
}

/// True if a graphical display exists, which a browser needs.
bool has_display() {
  return std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY");
}

void open_browser(const std::string& address) {
  const std::string opener = subprocess::find_program("xdg-open");
  if (opener.empty() || !has_display()) return;
  subprocess::run_process({.command = {opener, address}, .limit = std::chrono::seconds(10)});
}

ExitCode serve(const StudioWords& words, const Registry& registry) {
  const EndDelay delay(EndDelay::Signals::first);
  const studio::Studio studio(call_of(words), registry);
  if (studio::page_table().empty())
    complain("the program was built without its page; './stepwire setup' in its checkout builds it\n");
  put_data(studio.address() + "\n");
  finish_output();
  if (!words.no_open) open_browser(studio.address());
  while (!interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return ExitCode::done;
}

Action declare_studio(CLI::App& verb) {
  const auto words = std::make_shared<StudioWords>();
  verb.add_option("FILE", words->file, "a diagram file")->required();
  verb.add_option("--port", words->port, "at which it serves; 0, as without it, is any free one");
  verb.add_option("--out", words->out, "folder in which the page keeps a run, for 'verify'");
  verb.add_flag("--no-open", words->no_open, "print the address and open no browser");
  CLI::Option* const loop =
      verb.add_flag("--loop", words->loop, "run it as a real-time loop, and show how well it keeps time");
  for (CLI::Option* const timing : add_timing_options(verb, words->timing)) timing->needs(loop);
  return [words](const Registry& registry) { return serve(*words, registry); };
}

}  // namespace

Verb studio_verb() {
  return {"studio", "a live page for a diagram: text, drawing, run",
          "Example:\n  stepwire studio cart.yaml\nIt ends by Ctrl-C.", declare_studio};
}

}  // namespace stepwire::cli
