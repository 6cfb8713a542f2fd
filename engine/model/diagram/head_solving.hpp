#pragma once

#include "engine/model/diagram/head_keys.hpp"

namespace stepwire::diagram {

/// Rows `solver`, `algebraic_loops` and `events` of the head.
yaml::KeyRow<Diagram, HeadReading> solver_row();
yaml::KeyRow<Diagram, HeadReading> loops_row();
yaml::KeyRow<Diagram, HeadReading> events_row();

}  // namespace stepwire::diagram
