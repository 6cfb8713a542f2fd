#pragma once

#include <string>

#include "engine/simulate/codegen/statements.hpp"

namespace stepwire::codegen {

/// Returns the body of look(w, numbers, tick, z), which writes all crossing functions to `z`.
std::string look_text(const plan::Plan& plan, const Statements& statements, const Places& places);

/// Returns the body of next_edge(w, numbers, tick): the time of the next jump or kink of a source.
std::string edge_text(const plan::Plan& plan, const Statements& statements, const Places& places);

/// Returns the body of locate(w, numbers, tick, scratch), which repeats a step that contains a crossing, from
/// event to event. It calls `slopes_in_place`, `follow_time`, `follow_crossings`, `before_instant`,
/// `event_befores`, `event_outputs`, `event_updates`, `look` and `next_edge`.
std::string locate_text(const plan::Plan& plan, const PlaceNames& names);

/// Returns the body of settle_tick(w, numbers, tick), which repeats the discrete phase of a tick whose
/// updates have changed states.
std::string settle_text(const plan::Plan& plan, const PlaceNames& names);
/// Returns the statements of advance() that update the blocks at a tick.
std::string update_text(const plan::Plan& plan);
/// Returns the statement of advance() that lets blocks see the limits at its end.
std::string end_of_left_text(const plan::Plan& plan);

/// Return the statements of advance() before and after the solver's step: the check for crossings, and the
/// call of locate() if there is one.
std::string before_step_text(const plan::Plan& plan);
std::string after_step_text(const plan::Plan& plan);

/// True if the solver has error control, so that crossings are checked after each of its steps. locate() then
/// takes the steps of the solver too.
bool watches(const plan::Plan& plan);

/// Returns the time of the last stage of a step.
std::string end_of_step_text(const plan::Plan& plan);
/// Returns the declarations of `length`, `now` and `end` of a step.
std::string times_of_step_text(const plan::Plan& plan);

}  // namespace stepwire::codegen
