#include <CLI/CLI.hpp>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/simulate/realtime/readiness.hpp"

namespace stepwire::cli {
namespace {

Action declare_check(CLI::App&) {
  return [](const Registry&) {
    bool all = true;
    for (const realtime::Readiness& line : realtime::readiness()) {
      say("{} {}: {}\n", line.fits ? "ok  " : "weak", line.what, text::visible(line.found));
      if (!line.fits) say("       {}\n", line.cure);
      all = all && line.fits;
    }
    return all ? ExitCode::done : ExitCode::fails;
  };
}

}  // namespace

Verb realtime_check_verb() {
  return {"realtime-check", "check what keeps this machine from serving deadlines, with cures",
          "Example:\n  stepwire realtime-check\nThe exit code is 1 where a line is weak.", declare_check};
}

}  // namespace stepwire::cli
