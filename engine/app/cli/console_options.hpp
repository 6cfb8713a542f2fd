#pragma once

namespace CLI {
class App;
}  // namespace CLI

namespace stepwire::cli {

/// Declares --quiet and --color for the program and all its verbs.
void add_console_options(CLI::App& program);

}  // namespace stepwire::cli
