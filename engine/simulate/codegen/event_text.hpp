#pragma once

#include <string>

#include "engine/simulate/codegen/statements.hpp"

namespace stepwire::codegen {

/// The body of look(w, numbers, tick, z), which writes all crossings to `z`.
std::string look_text(const plan::Plan& plan, const Statements& statements, const Places& places);

/// The body of next_edge(w, numbers, tick): when a source jumps or bends next.
std::string edge_text(const plan::Plan& plan, const Statements& statements, const Places& places);

/// The body of locate(w, numbers, tick, scratch), which goes again over a step in which something has
/// crossed. It calls `slopes_in_place`, `follow_time`, `follow_crossings`, `event_befores`, `event_outputs`,
/// `event_updates`, `look` and `next_edge`.
std::string locate_text(const plan::Plan& plan, const PlaceNames& names);

/// In advance(), what comes before and behind the solver's step: looks for crossings, and where there is one
/// a call of locate().
std::string before_step_text(const plan::Plan& plan);
std::string after_step_text(const plan::Plan& plan);

/// True where a solver chooses its steps, behind each of which crossings are looked at. Then locate() takes
/// its steps, too.
bool watches(const plan::Plan& plan);

/// The time at which the last stage of a step is computed.
std::string end_of_step_text(const plan::Plan& plan);
/// Declares `length`, `now` and `end` of a step.
std::string times_of_step_text(const plan::Plan& plan);

}  // namespace stepwire::codegen
