#pragma once

#include <atomic>
#include <string>

#include "engine/app/session/loaded_model.hpp"
#include "engine/base/json/json.hpp"
#include "engine/simulate/profile/profile.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::report {

/// Profiles a file with its own values (none of its sweep's), by the steady clock; ends early once
/// `interrupt` is true.
profile::Profile profile_of(const session::LoadedModel& model, const std::atomic<bool>* interrupt);

/// Where the time of a run goes, for people: the most expensive blocks, and what the run does itself.
std::string profile_text(const session::LoadedModel& model, const profile::Profile& profile);
/// All of it, a row for each block, part, and what the run does itself.
std::string profile_csv(const profile::Profile& profile);
json::Json profile_json(const profile::Profile& profile);
/// The most expensive blocks as a figure.
plot::FigureSpec profile_figure(const session::LoadedModel& model, const profile::Profile& profile);

}  // namespace stepwire::report
