#pragma once

#include <string>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/view/drawing/graph_options.hpp"
#include "engine/view/drawing/hierarchy.hpp"

namespace stepwire::drawing {

/// Returns a diagram as the graph that draw.mjs draws. Its parts are
///
///   graph: {title (of the whole), inputs: [port], outputs: [port], nodes: [node], wires: [wire],
///          groups: [{name, members: [id]}] (of the whole)}
///
///   node: {id, name, type, part, outline, lines, fraction, curve, axes, state, inputs: [port], outputs:
///          [port], graph (of an opened part)}
///
///   port: {port, label, sign, recorded, mark (text on the wire that begins there)}; listed if connected or
///   recorded
///
///   wire: {from: end, to: end, unit}
///   end: {node, port} or {constant}; the node "" is the file itself.
///
/// Names to be opened that do not exist are ignored.
json::Json graph_of(const diagram::Diagram& diagram, const Hierarchy& hierarchy, const GraphOptions& options);

/// Returns the drawn signals, which may have labels.
std::vector<std::string> drawn_signals(const diagram::Diagram& diagram, const Hierarchy& hierarchy,
                                       const GraphOptions& options);

}  // namespace stepwire::drawing
