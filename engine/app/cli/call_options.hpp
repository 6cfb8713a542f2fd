#pragma once

#include <string>
#include <vector>

#include "engine/app/session/loop_settings.hpp"
#include "engine/simulate/device/gpu_runs.hpp"
#include "engine/simulate/run/tiered_execution.hpp"

namespace CLI {
class App;
class Error;
class Option;
class Validator;
}  // namespace CLI

namespace stepwire::cli {

/// Returns the validator of an option that takes one word of a list. A misspelt word is refused with the
/// nearest one.
CLI::Validator choice(const std::vector<std::string>& words);

/// Returns the names of the long options of a verb or program, with dashes.
std::vector<std::string> long_options(const CLI::App& app);

/// Returns the message about a call with a fault: for an unknown option, with the nearest one of its verb.
std::string fault_of_call(const CLI::App& program, const CLI::Error& error);

/// Adds options that several verbs have.
void add_engine_option(CLI::App& verb, run::ExecutionMode& engine, const std::string& what);

void add_device_option(CLI::App& verb, device::DeviceUse& device);

/// Declares the timing options of a real-time loop: --rate, --policy, --cpu, --overrun, --spin. Returns them.
std::vector<CLI::Option*> add_timing_options(CLI::App& verb, session::LoopWords& words);

}  // namespace stepwire::cli
