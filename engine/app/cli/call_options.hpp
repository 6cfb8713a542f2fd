#pragma once

#include <string>

#include "engine/simulate/run/tiered_execution.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace stepwire {

/// Options that several verbs have.
void add_engine_option(CLI::App& verb, ExecutionMode& engine, const std::string& what);
/// What is written to; an empty name is refused.
CLI::Option* add_out_option(CLI::App& verb, const std::string& names, std::string& out,
                            const std::string& what);

}  // namespace stepwire
