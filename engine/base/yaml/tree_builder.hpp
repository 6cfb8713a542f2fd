#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::yaml {

/// From the first character of a value to just behind its last one.
struct MarkRange {
  Mark mark, end;
};

/// A tree of nodes that grows with what a reader finds from top to bottom. It checks keys, expands aliases
/// and keeps the limits on depth and size. `anchor` is 0 where a value has none.
class TreeBuilder {
 public:
  TreeBuilder(std::string file, const DocumentLimits& limits);

  void open(Node::Kind kind, Mark mark, std::size_t anchor);
  /// Ends the list or map that was opened last; `end` is just behind it.
  void close(Mark end);
  void scalar(const MarkRange& place, const std::string& text, bool quoted, std::size_t anchor);
  /// A value that is written as null, or one that is absent: that has no place but the one of its key.
  void empty(const MarkRange& place, bool written, std::size_t anchor);
  void alias(Mark mark, std::size_t anchor);

  /// Is what comes next the key of a map?
  bool awaits_key() const;
  /// Where the list or map starts that is read just now.
  Mark innermost() const;

  /// Notes a fault after which reading goes on; ends the reading if there are too many.
  void fault(Mark mark, Message message);
  /// Ends the reading with all that was found.
  [[noreturn]] void fail(Mark mark, Message message);
  /// The finished tree; throws Error if there were faults.
  Node take();

 private:
  struct Level {
    Node* node;
    bool awaits_value = false;
  };
  using Path = std::vector<std::size_t>;

  void key(const MarkRange& place, std::string text, std::size_t anchor);
  Node& attach(Node node, std::size_t anchor);
  void spend(std::size_t cost, Mark mark);
  void check_depth(std::size_t depth, Mark mark);
  void check_double_keys(const Node& map);
  Node& at(const Path& path);

  std::string file_;
  DocumentLimits limits_;
  Node root_;
  std::vector<Level> open_;  // pointers stay good: a vector grows only while none of its elements is open
  std::unordered_map<std::size_t, Path> anchors_;
  std::size_t cost_ = 0;
  Faults faults_;
};

}  // namespace stepwire::yaml
