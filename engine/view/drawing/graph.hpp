#pragma once

#include <string>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/view/drawing/graph_options.hpp"
#include "engine/view/drawing/hierarchy.hpp"

namespace stepwire::drawing {

/// A diagram as the graph that draw.mjs draws:
///   graph: {title (of the whole), inputs: [port], outputs: [port], nodes: [node], wires: [wire],
///          groups: [{name, members: [id]}] (of the whole)}
///   node: {id, name, type, part, outline, lines, fraction, curve, axes, state, inputs: [port], outputs:
///   [port],
///          graph (of an opened part)}
///   port: {port, label, sign, recorded, mark (text on the wire that begins there)}; only what is fed, wired
///   or recorded has one wire: {from: end, to: end, unit} end: {node, port} or {constant}; the node "" is the
///   file itself.
/// What is to be opened and is not there is passed over.
json::Json graph_of(const diagram::Diagram& diagram, const Hierarchy& hierarchy, const GraphOptions& options);

/// The signals that are drawn: those that labels can be on.
std::vector<std::string> drawn_signals(const diagram::Diagram& diagram, const Hierarchy& hierarchy,
                                       const GraphOptions& options);

}  // namespace stepwire::drawing
