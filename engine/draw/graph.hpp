#pragma once

#include <string>
#include <vector>

#include "engine/draw/sheet.hpp"
#include "engine/table/json.hpp"

namespace stepwire {

/// What a drawing shows of a diagram.
struct GraphOptions {
  int depth = 0;                  ///< parts are opened so many levels deep
  std::vector<std::string> open;  ///< and these, by full name ("rig.mount"), with all that they lie in
  bool units = false;             ///< wires carry the unit of their signal
};

/// A diagram as the graph that draw.mjs draws:
///   graph: {title (of the whole), inputs: [port], outputs: [port], nodes: [node], wires: [wire]}
///   node: {id, name, type, part, outline, lines, fraction, curve, axes, state, inputs: [port], outputs:
///   [port],
///          graph (of an opened part)}
///   port: {port, label, sign, recorded}; only what is fed, wired or recorded has one
///   wire: {from: end, to: end, unit}
///   end: {node, port} or {constant}; the node "" is the file itself.
/// What is to be opened and is not there is passed over.
Json graph_of(const Diagram& diagram, const Sheet& sheet, const GraphOptions& options);

}  // namespace stepwire
