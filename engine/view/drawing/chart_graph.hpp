#pragma once

#include <optional>
#include <string>

#include "engine/base/json/json.hpp"
#include "engine/model/block/value.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::drawing {

/// Returns the states of a block with a tree `states`, such as StateMachine; std::nullopt for other blocks.
std::optional<Value> chart_of(const diagram::DiagramBlock& block);

/// Returns states as nodes and transitions as wires, in the graph format of graph.hpp; `id` is that of the
/// block. A state that holds others is a group of these and also a node of that group.
json::Json chart_graph(const Value& states, const std::string& id);

}  // namespace stepwire::drawing
