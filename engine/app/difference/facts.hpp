#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/app/difference/canonical.hpp"
#include "engine/app/difference/texts.hpp"
#include "engine/app/language/written_names.hpp"

namespace stepwire::difference {

/// One thing that a diagram file states, or a group of these. Facts of two files are equal where the files
/// mean the same; order of keys, comments, layout, units of a number and repeated defaults do not count.
struct Fact {
  enum class Kind {
    value,     ///< A scalar.
    map,       ///< Facts under keys.
    sequence,  ///< Items whose order counts.
    set        ///< Items whose order does not count: claims, figures.
  };
  Kind kind = Kind::value;
  std::string key{};               ///< Canonical key in its map; empty for an item.
  std::string canonical{};         ///< Text of the whole fact, the same for equal facts.
  std::string written{};           ///< Text as in the file, in one line.
  std::string otherwise{};         ///< Default; may be empty.
  bool is_wire = false;            ///< Source of an input.
  std::optional<double> number{};  ///< Of a plain number, in SI.
  yaml::Mark mark{};               ///< Of the key, or of an item.
  std::vector<Fact> parts{};
  std::vector<Fact> defaults{};        ///< Parts that are written and state what holds without them.
  const yaml::Node* node = nullptr;    ///< Value in the file; nullptr for a default.
  const yaml::Entry* entry = nullptr;  ///< Its key; nullptr for an item.

  /// Returns the part under a key; nullptr if it is missing. The search is linear, see PartsByKey.
  const Fact* find(std::string_view name) const;
  bool is_map() const { return kind == Kind::map; }
};

/// Index of the parts of a map, for loops over maps of many parts. The map must outlive it, and keep its
/// parts.
class PartsByKey {
 public:
  explicit PartsByKey(const Fact& map);
  /// Returns the part under a key without marks; nullptr if it is missing.
  const Fact* find(const std::string& name) const;

 private:
  const Fact& map_;
  std::unordered_map<std::string, const Fact*> parts_;  ///< Empty for a map of few parts.
};

/// Facts of one file.
struct FileFacts {
  std::string file;
  const DiagramText* source = nullptr;
  Fact root;
};

/// Reads the facts of files. Defaults, order without meaning and units follow from the key tables of the
/// reader and the declarations of the blocks.
class FactReader {
 public:
  FactReader(const Registry& registry, Texts& texts) : registry_(registry), texts_(texts), forms_(registry) {}

  /// Throws yaml::Error for an unreadable file.
  FileFacts read(const std::string& file);
  /// Returns the default of a parameter of a block; empty if its type has no such parameter.
  std::string default_of(const Fact& block, const std::string& parameter) const;

 private:
  class Reading;

  const Registry& registry_;
  Texts& texts_;
  language::Forms forms_;
};

/// Replaces names in a fact and all its parts.
void rename(Fact& fact, const NewNames& names);
/// New names within parts, by the canonical keys of the blocks that use them.
using NamesInside = std::map<std::string, NewNames>;
/// Replaces names of parts in the file that uses them.
void rename_inside(Fact& fact, const NamesInside& inside);
/// Computes the canonical text of a group from those of its parts.
void join_parts(Fact& fact);
/// Returns a name for an item of a set: its sentence or title, or its text.
std::string label_of(const Fact& item);
/// Returns the type of a block, the file of a part, or "bus".
std::string type_of(const Fact& block);

}  // namespace stepwire::difference
