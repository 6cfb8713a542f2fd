#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/yaml/error.hpp"
#include "engine/base/yaml/place.hpp"

namespace stepwire::yaml {

struct Entry;

/// A value of a YAML file with its location. Aliases are expanded to their targets, with the locations of
/// these; scalars are kept as text.
struct Node {
  enum class Kind { empty, scalar, list, map };

  Kind kind = Kind::empty;
  bool quoted = false;  ///< A quoted scalar: always text, never a number or a word such as true.
  Mark mark;            ///< Mark of its first character; for a block map that of its first key.
  Mark end;             ///< Mark just after its last character; for an omitted value that of its key.
  std::string text;
  std::vector<Node> items;
  std::vector<Entry> entries;

  /// Returns the value of a key; nullptr if it is missing. The search is linear, for maps of few keys.
  const Node* find(std::string_view key) const;
  bool is_map() const { return kind == Kind::map; }
  bool is_list() const { return kind == Kind::list; }
  bool is_scalar() const { return kind == Kind::scalar; }
  /// Returns the items of a list, or this value as the only item.
  std::span<const Node> as_list() const;
};

/// A key of a map with its own location.
struct Entry {
  std::string key;
  Mark mark;
  Node value;
  Mark end{};  ///< just after the key
};

inline std::span<const Node> Node::as_list() const {
  return is_list() ? std::span<const Node>(items) : std::span<const Node>(this, 1);
}

/// Limits on the cost of a document.
struct DocumentLimits {
  std::size_t bytes = 8u << 20;
  int depth = 64;
  std::size_t nodes = 1'000'000;  ///< values after alias expansion; long texts and anchors count as several
};

/// A YAML file as a tree with locations.
struct Document {
  std::string file;
  Node root;
};

/// Parses one YAML document. Throws Error for invalid YAML and for duplicate keys (all of them). Merge keys,
/// tags, several documents in one file, unknown aliases, non-scalar keys and anything beyond the limits are
/// errors as well. An empty file gives a root of kind empty at 1:1.
Document parse_document(std::string_view text, const std::string& file, const DocumentLimits& limits = {});

/// Reads and parses a file. A file that is missing, unreadable, a folder or too large is an Error at line 0.
Document read_document(const std::string& path, const DocumentLimits& limits = {});

}  // namespace stepwire::yaml
