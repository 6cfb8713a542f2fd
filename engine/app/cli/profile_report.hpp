#pragma once

#include <string>

#include "engine/app/cli/work.hpp"
#include "engine/base/json/json.hpp"
#include "engine/simulate/profile/profile.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire {

/// Profiles a file with its own values (none of its sweep's), by the steady clock.
Profile profile_of(const Work& work);

/// Where the time of a run goes, for people: the most expensive blocks, and what the run does itself.
std::string profile_text(const Work& work, const Profile& profile);
/// All of it, a row for each block, part, and what the run does itself.
std::string profile_csv(const Profile& profile);
Json profile_json(const Profile& profile);
/// The most expensive blocks as a figure.
FigureSpec profile_figure(const Work& work, const Profile& profile);

}  // namespace stepwire
