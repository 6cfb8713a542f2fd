#include "engine/app/cli/console_options.hpp"

#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "engine/app/cli/choice.hpp"
#include "engine/app/cli/console_style.hpp"

namespace stepwire::cli {

namespace {

const std::map<std::string, Color> colors{
    {"auto", Color::automatic}, {"always", Color::always}, {"never", Color::never}};

void add_options(CLI::App& app) {
  app.add_flag_callback(
      "--quiet", [] { console_style().quiet = true; }, "print errors, failures and data alone");
  app.add_option_function<std::string>(
         "--color", [](const std::string& word) { console_style().color = colors.at(word); },
         "colours; auto: on a terminal, unless NO_COLOR is set")
      ->check(Choice({"auto", "always", "never"}));
}

}  // namespace

void add_console_options(CLI::App& program) {
  add_options(program);
  for (CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) add_options(*verb);
}

}  // namespace stepwire::cli
