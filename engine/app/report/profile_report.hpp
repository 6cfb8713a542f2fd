#pragma once

#include <atomic>
#include <string>

#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/run_result.hpp"
#include "engine/simulate/profile/profile.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::report {

/// Profile of a run with its fields for JSON.
struct ProfileReport : profile::Profile {};
void declare(result::Record<ProfileReport>& is);

/// Profiles a run with the file's own values, without its sweep, by the steady clock. Ends early after
/// `interrupt` becomes true.
profile::Profile profile_of(const session::LoadedModel& model, const std::atomic<bool>* interrupt);

/// Returns the most expensive blocks and the costs of the run itself, as text.
std::string profile_text(const session::LoadedModel& model, const profile::Profile& profile);
/// Returns the whole profile: a row for each block, each part and each cost of the run itself.
std::string profile_csv(const profile::Profile& profile);
/// Returns a figure of the most expensive blocks.
plot::FigureSpec profile_figure(const session::LoadedModel& model, const profile::Profile& profile);

}  // namespace stepwire::report
