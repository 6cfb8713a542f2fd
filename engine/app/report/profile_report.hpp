#pragma once

#include <atomic>
#include <string>

#include "engine/app/session/loaded_model.hpp"
#include "engine/base/json/json.hpp"
#include "engine/simulate/profile/profile.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire {

/// Profiles a file with its own values (none of its sweep's), by the steady clock; ends early once
/// `interrupt` is true.
Profile profile_of(const LoadedModel& model, const std::atomic<bool>* interrupt);

/// Where the time of a run goes, for people: the most expensive blocks, and what the run does itself.
std::string profile_text(const LoadedModel& model, const Profile& profile);
/// All of it, a row for each block, part, and what the run does itself.
std::string profile_csv(const Profile& profile);
Json profile_json(const Profile& profile);
/// The most expensive blocks as a figure.
FigureSpec profile_figure(const LoadedModel& model, const Profile& profile);

}  // namespace stepwire
