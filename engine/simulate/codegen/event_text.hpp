#pragma once

#include <string>

#include "engine/simulate/codegen/statements.hpp"

namespace stepwire::codegen {

/// The body of look(w, numbers, tick, z), which writes all crossings to `z`.
std::string look_text(const plan::Plan& plan, const Statements& statements, const Places& places);

/// The body of advance() where events are located. It calls `update`, `slopes`, `derivatives`, `follow_time`,
/// `crossing_outputs`, `event_outputs`, `event_updates` and `look`.
std::string located_advance_text(const plan::Plan& plan, const PlaceNames& names);

}  // namespace stepwire::codegen
