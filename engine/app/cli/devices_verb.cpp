#include <CLI/CLI.hpp>
#include <array>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/base/driver/open_device.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::cli {
namespace {

void show_driver(const stepwire_driver& driver, const std::string& file) {
  say("{}: {}{}\n  {}\n", driver.name, driver.doc, driver.wait ? "; may be the clock" : "", file);
  for (const stepwire_known_setting* one = driver.settings; one->key; ++one)
    say("    {:<15} {}{}\n", one->key, one->doc,
        !one->otherwise   ? "; required"
        : *one->otherwise ? fmt::format("; {} by default", one->otherwise)
                          : "");
  std::array<char, 4096> text{};
  if (driver.list) driver.list(text.data(), text.size());
  if (text.front()) say("  plugged in:\n{}\n", text.data());
}

Action declare_devices(CLI::App&) {
  return [](const Registry&) {
    ExitCode code = ExitCode::done;
    for (const driver::FoundDriver& found : driver::found_drivers()) try {
        show_driver(driver::load_driver(found.file), found.file);
      } catch (const io::EnvironmentError& error) {
        complain("{}\n", error.what());
        code = ExitCode::surroundings;
      }
    return code;
  };
}

}  // namespace

Verb devices_verb() {
  return {"devices", "list the drivers of devices with their settings, and what is plugged in",
          "Example:\n  stepwire devices", declare_devices};
}

}  // namespace stepwire::cli
