#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/view/drawing/graph_options.hpp"
#include "engine/view/drawing/hierarchy.hpp"

namespace stepwire::drawing {

/// What of a diagram's hierarchies is drawn: all but what is hidden, and of each child the outputs that lead
/// somewhere.
class Selection {
 public:
  /// The outputs of a child that are drawn; none where `hidden`.
  struct Shown {
    bool hidden = false;
    std::vector<int> outputs;
  };

  /// One thing that an input is fed by.
  struct Feed {
    const ReferenceInput* input = nullptr;
    std::size_t index = 0;  ///< in its list
  };

  /// `hierarchy` is the file that is drawn.
  Selection(const diagram::Diagram& diagram, const Hierarchy& hierarchy, const GraphOptions& options);

  /// Full name of a file's block, seen from the file that is drawn.
  std::string name_in(const Hierarchy& hierarchy, const std::string& name) const;
  /// For each child of a file, of whose own outputs `own` are drawn.
  std::vector<Shown> shown(const Hierarchy& hierarchy, const std::vector<int>& own) const;
  /// The outputs of the file itself that are drawn.
  std::vector<int> own_outputs(const Hierarchy& hierarchy) const;
  /// What is drawn of all that a child is fed by: not what is hidden, nor what an opened part needs for
  /// hidden blocks only.
  std::vector<Feed> feeds(const Hierarchy& hierarchy, const BlockReference& child, int depth) const;
  bool is_recorded(const Hierarchy& hierarchy, const WireSource& source) const;
  bool is_open(const std::string& name, int depth) const;

 private:
  bool hides(const std::string& name) const;
  /// Is this signal left out, itself or with the block that gives it?
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
  std::size_t above_;  ///< letters that lie above the file that is drawn
  std::set<std::pair<int, int>> recorded_;
};

}  // namespace stepwire::drawing
