#pragma once

#include <string>

#include "engine/app/cli/commands.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace stepwire {

/// Options that several verbs have.
void add_engine_option(CLI::App& verb, Engine& engine, const std::string& what);
void add_fit_options(CLI::App& verb, FitWords& words);
void add_study_options(CLI::App& verb, RunCommand& command);
void add_loop_options(CLI::App& verb, LoopCommand& command);
/// What is written to; an empty name is refused.
CLI::Option* add_out_option(CLI::App& verb, const std::string& names, std::string& out,
                            const std::string& what);

}  // namespace stepwire
