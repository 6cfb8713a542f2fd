#pragma once

#include <string>

#include "engine/view/drawing/graph.hpp"

namespace stepwire::drawing {

/// Drawable view of a checked diagram. The diagram and the documents that it was loaded from must outlive it.
class DiagramView {
 public:
  /// `scope` is the drawn file: the diagram itself, or a part of it.
  DiagramView(const diagram::Diagram& diagram, diagram::Loader& loader, int scope = 0)
      : diagram_(diagram), loader_(loader), scope_(scope) {}

  const diagram::Diagram& diagram() const { return diagram_; }
  int scope() const { return scope_; }
  /// Returns the names of all parts that can be opened: "rig", "rig.mount".
  std::vector<std::string> parts() const;
  json::Json graph(const GraphOptions& options) const;
  /// Returns the names of all blocks and parts of the file and of its parts; with `signals` also those of
  /// their outputs.
  std::vector<std::string> blocks(bool signals) const;
  /// Returns the blocks and parts of the file itself.
  std::vector<std::string> children() const;
  /// Returns the signals in a drawing with these options, which may have labels.
  std::vector<std::string> signals(const GraphOptions& options) const;

 private:
  const diagram::Diagram& diagram_;
  diagram::Loader& loader_;
  int scope_;
};

/// Diagram file, or file of a part, to be drawn.
class DrawnFile {
 public:
  /// Loads and checks the file. Throws Error with all faults.
  DrawnFile(diagram::Loader& loader, const std::string& path);

  const DiagramView& view() const { return view_; }

 private:
  diagram::Diagram diagram_;
  DiagramView view_;
};

/// Returns a graph, or a mechanism in the format of rig.mjs, as SVG. The same JSON gives the same bytes. A
/// layout takes seconds, so pictures are cached in cache_folder(). Throws EnvironmentError if node or elkjs
/// is missing.
std::string draw_picture(const json::Json& drawn);

}  // namespace stepwire::drawing
