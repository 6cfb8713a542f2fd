#pragma once

#include <string>

#include "engine/app/session/loop_outcome.hpp"
#include "engine/base/json/json.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::session {

/// Returns all results and histograms of a loop as JSON. Times are in ns unless the key names another unit.
json::Json loop_json(const LoopOutcome& outcome);
/// Returns a figure with two panels: the histograms of wake-up latency, response and step cost, and their
/// longest times over the run.
plot::FigureSpec loop_figure(const LoopOutcome& outcome);

/// Returns "done", "stopped", ...
std::string end_word(realtime::Loop::End end);

}  // namespace stepwire::session
