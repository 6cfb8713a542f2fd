#include <CLI/CLI.hpp>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/base/driver/open_device.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/guard/survey.hpp"

namespace stepwire::cli {
namespace {

void show_driver(const guard::SurveyedDevice& driver, const std::string& file) {
  say("{}: {}{}\n  {}\n", driver.driver, driver.doc, driver.is_clock ? "; may be the clock" : "", file);
  for (const guard::KnownSetting& one : driver.settings)
    say("    {:<15} {}{}\n", one.key, one.doc,
        !one.otherwise            ? "; required"
        : !one.otherwise->empty() ? fmt::format("; {} by default", *one.otherwise)
                                  : "");
  if (!driver.plugged_in.empty()) say("  plugged in:\n{}\n", driver.plugged_in);
}

/// Shows a driver. Returns false, with the reason on the standard error, where it fails.
bool show(const driver::FoundDriver& found) {
  const auto answers = guard::survey({{found.name, found.name, found.file, {}}}, guard::SurveyDepth::list,
                                     guard::longest_survey, &interrupted());
  if (!answers) throw subprocess::ProcessStopped("the list of the drivers was interrupted");
  const guard::SurveyedDevice& driver = answers->front();
  if (!driver.driver.empty()) show_driver(driver, found.file);
  if (!driver.failure.empty()) complain("{}\n", driver.failure);
  return driver.failure.empty();
}

Action declare_devices(CLI::App&) {
  return [](const Registry&) {
    ExitCode code = ExitCode::done;
    for (const driver::FoundDriver& found : driver::found_drivers())
      if (!show(found)) code = ExitCode::surroundings;
    return code;
  };
}

}  // namespace

Verb devices_verb() {
  return {"devices", "list the drivers of devices with their settings, and what is plugged in",
          "Example:\n  stepwire devices", declare_devices};
}

}  // namespace stepwire::cli
