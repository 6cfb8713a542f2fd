#pragma once

#include <string>

#include "engine/view/drawing/graph.hpp"

namespace stepwire::drawing {

/// A checked diagram as it is drawn; for as long as the diagram and the documents that it was loaded from are
/// there.
class DiagramView {
 public:
  /// `scope` is the file that is drawn: the diagram itself, or one that it uses as a part.
  DiagramView(const diagram::Diagram& diagram, diagram::Loader& loader, int scope = 0)
      : diagram_(diagram), loader_(loader), scope_(scope) {}

  const diagram::Diagram& diagram() const { return diagram_; }
  int scope() const { return scope_; }
  /// Names of all parts that can be opened: "rig", "rig.mount".
  std::vector<std::string> parts() const;
  json::Json graph(const GraphOptions& options) const;
  /// Names of all blocks and parts of the file and of its parts; with their outputs where `signals`.
  std::vector<std::string> blocks(bool signals) const;
  /// The blocks and parts of the file itself.
  std::vector<std::string> children() const;
  /// The signals that a drawing with these options has: those that labels can be on.
  std::vector<std::string> signals(const GraphOptions& options) const;

 private:
  const diagram::Diagram& diagram_;
  diagram::Loader& loader_;
  int scope_;
};

/// A diagram file, or one that is only used as a part, to be drawn.
class DrawnFile {
 public:
  /// Loads and checks. Throws Error with everything that is wrong.
  DrawnFile(diagram::Loader& loader, const std::string& path);

  const DiagramView& view() const { return view_; }

 private:
  diagram::Diagram diagram_;
  DiagramView view_;
};

/// The picture of a graph, or of a mechanism as rig.mjs describes it, as SVG; the same JSON gives the same
/// bytes. A picture is kept in cache_folder(), since laying one out takes seconds. Throws EnvironmentError
/// where node or elkjs is missing.
std::string draw_picture(const json::Json& drawn);

}  // namespace stepwire::drawing
