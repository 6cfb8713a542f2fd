#pragma once

#include <optional>
#include <string>

#include "engine/base/json/json.hpp"
#include "engine/model/block/value.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::drawing {

/// The states of a block that has some (its tree `states`), as StateMachine; nothing for other blocks.
std::optional<Value> chart_of(const diagram::DiagramBlock& block);

/// States as nodes and transitions as wires, in the graph of graph.hpp; `id` is that of the block. A state
/// that holds others is a group of these, in which it stands itself.
json::Json chart_graph(const Value& states, const std::string& id);

}  // namespace stepwire::drawing
