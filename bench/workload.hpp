#pragma once

#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire {

/// Returns the plan of W1, from its file w1.yaml.
plan::Plan w1_plan();

/// Returns the diagram file of W2: a graph of `blocks` blocks, and 2 for the source. It records 8 of its
/// signals.
std::string w2_text(int blocks, int steps);

/// Returns the plan of W2.
plan::Plan w2_plan(int blocks, int steps);

}  // namespace stepwire
