#pragma once

#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire {

/// W1 as a plan, from its file w1.yaml.
plan::Plan w1_plan();

/// W2, a graph of `blocks` blocks (and 2 for the source), as the text of a diagram file that records 8 of its
/// signals.
std::string w2_text(int blocks, int steps);

/// W2 as a plan.
plan::Plan w2_plan(int blocks, int steps);

}  // namespace stepwire
