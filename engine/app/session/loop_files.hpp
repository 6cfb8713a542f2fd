#pragma once

#include <string>

#include "engine/app/session/loop_outcome.hpp"
#include "engine/base/json/json.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::session {

/// What a loop has to tell and all histograms, for programs; times in ns unless the key says else.
json::Json loop_json(const LoopOutcome& outcome);
/// Two panels: how often each of wake-up latency, response and cost of a step was how long, and the
/// worst of each over time.
plot::FigureSpec loop_figure(const LoopOutcome& outcome);

/// "done", "stopped", ...
std::string end_word(realtime::Loop::End end);

}  // namespace stepwire::session
