#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/view/drawing/graph_options.hpp"
#include "engine/view/drawing/hierarchy.hpp"

namespace stepwire::drawing {

/// Selection of the drawn blocks and outputs: all but hidden blocks, and the outputs of each child that have
/// a sink.
class Selection {
 public:
  /// Drawn outputs of a child; an empty list if it is hidden.
  struct Shown {
    bool hidden = false;
    std::vector<int> outputs;
  };

  /// Connection of an input.
  struct Feed {
    const ReferenceInput* input = nullptr;
    std::size_t index = 0;  ///< in its list
  };

  /// `hierarchy` is the drawn file.
  Selection(const diagram::Diagram& diagram, const Hierarchy& hierarchy, const GraphOptions& options);

  /// Returns the full name of a block, relative to the drawn file.
  std::string name_in(const Hierarchy& hierarchy, const std::string& name) const;
  /// Returns the drawn outputs of each child of a file; `own` are the drawn outputs of the file itself.
  std::vector<Shown> shown(const Hierarchy& hierarchy, const std::vector<int>& own) const;
  /// Returns the drawn outputs of the file itself.
  std::vector<int> own_outputs(const Hierarchy& hierarchy) const;
  /// Returns the drawn connections of a child, without hidden sources and without inputs of an opened part
  /// that only hidden blocks use.
  std::vector<Feed> feeds(const Hierarchy& hierarchy, const BlockReference& child, int depth) const;
  bool is_recorded(const Hierarchy& hierarchy, const WireSource& source) const;
  bool is_open(const std::string& name, int depth) const;

 private:
  bool hides(const std::string& name) const;
  /// True if this signal is hidden, by itself or with its block.
  bool hides(const Hierarchy& hierarchy, const WireSource& source) const;
  bool feeds_hidden_only(const Hierarchy& part, const std::string& input) const;
  bool hides_child(const Hierarchy& hierarchy, const BlockReference& child) const {
    return hides(name_in(hierarchy, child.name));
  }
  std::vector<int> outputs_of(const Hierarchy& hierarchy, int child,
                              const std::set<std::pair<int, int>>& used) const;
  void add_recorded(const diagram::SignalRef& signal) { recorded_.insert({signal.block, signal.output}); }
  const std::string& scope_prefix(const Hierarchy& hierarchy) const {
    return diagram_.scopes[static_cast<std::size_t>(hierarchy.scope)].prefix;
  }

  const diagram::Diagram& diagram_;
  const GraphOptions& options_;
  std::size_t above_;  ///< length of the prefix above the drawn file
  std::set<std::pair<int, int>> recorded_;
};

}  // namespace stepwire::drawing
