#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/view/drawing/hierarchy.hpp"

namespace stepwire::drawing {

/// Blocks and parts of the file itself that are drawn in one frame, without being a part.
struct NodeGroup {
  std::string name;
  std::vector<std::string> members;
};

/// Content of a drawing. Names are full names relative to the drawn file: "rig.mount" for a part, "rig.force"
/// for a signal, or "spring" for a block with one output.
struct GraphOptions {
  int depth = 0;                              ///< Number of levels to which parts are opened.
  std::vector<std::string> open;              ///< Further parts to open, with all that contain them.
  bool units = false;                         ///< True for units on wires.
  std::vector<std::string> hide;              ///< Blocks, parts and signals to omit; '*' matches any letters.
  std::map<std::string, std::string> labels;  ///< Texts on the wires of signals.
  std::map<std::string, std::string> names;   ///< Displayed names of blocks and parts.
  std::vector<NodeGroup> groups;
};

/// True if a name matches a pattern, in which '*' matches any letters or none.
bool follows_pattern(const std::string& name, const std::string& pattern);

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
