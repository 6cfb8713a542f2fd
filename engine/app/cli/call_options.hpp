#pragma once

#include <string>

#include "engine/simulate/run/tiered_execution.hpp"

namespace CLI {
class App;
}  // namespace CLI

namespace stepwire::cli {

/// Adds options that several verbs have.
void add_engine_option(CLI::App& verb, run::ExecutionMode& engine, const std::string& what);

}  // namespace stepwire::cli
