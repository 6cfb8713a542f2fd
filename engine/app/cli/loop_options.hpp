#pragma once

#include <vector>

#include "engine/app/session/loop_settings.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace stepwire::cli {

/// Declares the timing options of a real-time loop: --rate, --policy, --cpu, --overrun, --spin. Returns them.
std::vector<CLI::Option*> add_timing_options(CLI::App& verb, session::LoopWords& words);

}  // namespace stepwire::cli
