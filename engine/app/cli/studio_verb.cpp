#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <thread>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/studio/page_table.hpp"
#include "engine/app/studio/studio.hpp"
#include "engine/base/subprocess/process.hpp"

namespace stepwire::cli {

namespace {

struct StudioWords {
  studio::StudioCall call;
  bool no_open = false;
};

/// There is a browser where there is a display.
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
  const studio::Studio studio(words.call, registry);
  if (studio::page_table().empty())
    complain("the program was built without its page; install npm and call ./stepwire again\n");
  say("{}\n", studio.address());
  finish_output();
  if (!words.no_open) open_browser(studio.address());
  while (!interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return ExitCode::done;
}

Action declare_studio(CLI::App& verb) {
  const auto words = std::make_shared<StudioWords>();
  verb.add_option("FILE", words->call.file, "a diagram file")->required();
  verb.add_option("--port", words->call.port, "at which it serves; any free one without it");
  verb.add_flag("--no-open", words->no_open, "print the address and open no browser");
  return [words](const Registry& registry) { return serve(*words, registry); };
}

}  // namespace

Verb studio_verb() {
  return {"studio", "a live page for a diagram: text, drawing, run",
          "Example:\n  stepwire studio cart.yaml\nIt ends by Ctrl-C.", declare_studio};
}

}  // namespace stepwire::cli
