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

/// One value of a YAML file, as it stands there. Aliases are expanded to what they name, with its places;
/// scalars are kept as text.
struct Node {
  enum class Kind { empty, scalar, list, map };

  Kind kind = Kind::empty;
  bool quoted = false;  ///< a scalar in quotes: text, never a number or a word like true
  Mark mark;            ///< of the value itself (first character); of the first key for a block map
  Mark end;             ///< just behind its last character; where it is left out, that of its key
  std::string text;
  std::vector<Node> items;
  std::vector<Entry> entries;

  /// The value under a key, or nullptr. Linear: for maps of few keys.
  const Node* find(std::string_view key) const;
  bool is_map() const { return kind == Kind::map; }
  bool is_list() const { return kind == Kind::list; }
  bool is_scalar() const { return kind == Kind::scalar; }
  /// The items of a list, or the one value.
  std::span<const Node> as_list() const;
};

/// A key of a map with its own place.
struct Entry {
  std::string key;
  Mark mark;
  Node value;
  Mark end{};  ///< just behind the key
};

inline std::span<const Node> Node::as_list() const {
  return is_list() ? std::span<const Node>(items) : std::span<const Node>(this, 1);
}

/// What a document may cost to read.
struct DocumentLimits {
  std::size_t bytes = 8u << 20;
  int depth = 64;
  std::size_t nodes =
      1'000'000;  ///< values after the expansion of aliases; long texts and anchors count as several
};

/// A YAML file as a tree with places.
struct Document {
  std::string file;
  Node root;
};

/// Reads one YAML document. Throws Error for what is not YAML, double keys (all of them), merge keys, tags,
/// several documents in one file, aliases to what is not there, keys that are no scalars, and anything beyond
/// the limits; an empty file gives a root of kind empty at 1:1.
Document parse_document(std::string_view text, const std::string& file, const DocumentLimits& limits = {});

/// The same from a file. A file that is missing, unreadable, a folder or too large is an Error at line 0
/// (its size is looked at before it is read).
Document read_document(const std::string& path, const DocumentLimits& limits = {});

}  // namespace stepwire::yaml
