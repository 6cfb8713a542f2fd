#pragma once

#include <map>
#include <string>
#include <vector>

namespace stepwire::drawing {

/// Blocks and parts of the file itself that are drawn in one frame, though no part of the file holds them.
struct NodeGroup {
  std::string name;
  std::vector<std::string> members;
};

/// What a drawing shows of a diagram. Names are full names, seen from the file that is drawn:
/// "rig.mount", and of a signal "rig.force", or "spring" where the block has one output.
struct GraphOptions {
  int depth = 0;                              ///< parts are opened so many levels deep
  std::vector<std::string> open;              ///< and these, with all that they lie in
  bool units = false;                         ///< wires carry the unit of their signal
  std::vector<std::string> hide;              ///< blocks, parts and signals; '*' stands for any letters
  std::map<std::string, std::string> labels;  ///< texts on the wires of signals
  std::map<std::string, std::string> names;   ///< names of blocks and parts where they differ from the file's
  std::vector<NodeGroup> groups;
};

/// Does a name follow a pattern in which '*' stands for any letters, also none?
bool follows_pattern(const std::string& name, const std::string& pattern);

}  // namespace stepwire::drawing
