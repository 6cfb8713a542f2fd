#pragma once

#include <string>

#include "engine/draw/graph.hpp"

namespace stepwire {

/// A diagram file, or a file that is to be used as a part: its outline, and the diagram in which it was
/// checked.
class DrawnFile {
 public:
  /// Loads and checks. Throws Error with everything that is wrong.
  DrawnFile(Loader& loader, const std::string& path);

  /// Names of all parts that can be opened: "rig", "rig.mount".
  std::vector<std::string> parts() const;
  Json graph(const GraphOptions& options) const;

 private:
  Diagram diagram_;
  std::string title_;
  std::unique_ptr<Outline> outline_;
};

/// The picture of a graph as SVG; the same graph gives the same bytes. Throws SurroundingsError where node or
/// elkjs is missing.
std::string draw_graph(const Json& graph);

}  // namespace stepwire
