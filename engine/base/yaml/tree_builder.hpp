#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::yaml {

/// Range from the first character of a value to just after its last one.
struct MarkRange {
  Mark mark, end;
};

/// Builds a tree of nodes from parser events. It checks keys, expands aliases and enforces the limits on
/// depth and size. `anchor` is 0 for a value without one.
class TreeBuilder {
 public:
  TreeBuilder(std::string file, const DocumentLimits& limits);

  void open(Node::Kind kind, Mark mark, std::size_t anchor);
  /// Closes the innermost open list or map; `end` is just after it.
  void close(Mark end);
  void scalar(const MarkRange& place, const std::string& text, bool quoted, std::size_t anchor);
  /// Adds a written null or an omitted value; the latter has the location of its key.
  void empty(const MarkRange& place, bool written, std::size_t anchor);
  void alias(Mark mark, std::size_t anchor);

  /// True where the next value is the key of a map.
  bool awaits_key() const;
  /// Returns the start of the innermost open list or map.
  Mark innermost() const;

  /// Records a fault and continues; throws Error after too many.
  void fault(Mark mark, Message message);
  /// Throws Error with this fault and all earlier ones.
  [[noreturn]] void fail(Mark mark, Message message);
  /// Returns the finished tree; throws Error if there were faults.
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
  std::vector<Level> open_;  // pointers remain valid: a vector grows only while none of its elements is open
  std::unordered_map<std::size_t, Path> anchors_;
  std::size_t cost_ = 0;
  Faults faults_;
};

}  // namespace stepwire::yaml
