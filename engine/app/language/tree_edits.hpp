#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/app/language/text_places.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::language {

/// Edits of a YAML text that keep its formatting.
/// Each edit is noted twice: as splices of the text, and as a change of the expected tree. The text is never
/// printed from a tree, so comments, quotes, brackets and line ends stay.
/// The function checked() parses the spliced text and compares it with the expected tree. So a splice cannot
/// silently change another value.
/// Nodes and entries are those of the document, which was parsed from the text. Both must outlive the object.
class TreeEdits {
 public:
  TreeEdits(std::string_view text, const yaml::Document& document);

  /// Replaces a value, given in plain notation: "8 kg", "[1, 2]", "max(a, b)". It is quoted if the context
  /// requires it or if the old value was quoted. All functions throw EditRefused for text that is no
  /// single-line value.
  void replace(const yaml::Node& value, const std::string& text);
  /// Adds a key at the end of a map, in the style of the map.
  void add(const yaml::Node& map, const std::string& key, const std::string& text);
  using Keys = std::vector<std::pair<std::string, std::string>>;
  /// Adds a key with a map as value, in the style of the last map in `map`.
  void add_map(const yaml::Node& map, const std::string& key, const Keys& keys);
  void add_item(const yaml::Node& list, const std::string& text);
  /// Adds to the value under a key of a map: a named entry, or with an empty name a list item. A missing key
  /// is added. A map as value becomes the first item of a list.
  void add_below(const yaml::Node& map, const std::string& key, const std::string& name,
                 const std::string& text);
  /// Removes a key with its value, and the comment in its last line.
  void remove(const yaml::Node& map, const yaml::Entry& entry);
  void remove_item(const yaml::Node& list, const yaml::Node& item);

  /// Returns the splices after parsing the spliced text. Throws EditRefused if it differs from the expected
  /// tree, for example because of an anchor, or is invalid YAML.
  std::vector<Splice> checked() const;
  /// Returns the expected tree of the changed text; new nodes have no positions.
  yaml::Document tree() const { return {document_.file, expected(document_.root)}; }

 private:
  struct Child {
    const void* id;
    TextRange range;  ///< range of an entry, or of an item without its dash
  };

  void note_parents(const yaml::Node& node);
  bool is_flow(const yaml::Node& node) const;
  bool stands_in_flow(const yaml::Node& node) const;
  void append(const yaml::Node& parent, const std::string& text);
  std::size_t end_of_lines(const yaml::Node& parent, std::size_t end) const;
  void begin(const yaml::Node& map, const yaml::Entry* entry, const std::string& key, const std::string& name,
             const std::string& text);
  void make_list(const yaml::Entry& entry, const std::string& text);
  void put_in_list(const yaml::Entry& entry);
  std::size_t value_end(const yaml::Node& value, std::size_t key_end) const;
  std::vector<Child> children(const yaml::Node& node) const;
  bool are_removed(const std::vector<Child>& all) const;
  void add_appended(const yaml::Node& parent, std::vector<Splice>& splices) const;
  void add_removals(const yaml::Node& node, std::vector<Splice>& splices) const;
  void remove_in_flow(const std::vector<Child>& all, std::vector<Splice>& splices) const;
  void remove_line(const yaml::Node& parent, const std::vector<Child>& all, std::size_t index,
                   std::vector<Splice>& splices) const;
  std::string indent(const yaml::Node& node) const;
  std::size_t line_start(std::size_t at) const;
  std::size_t line_end(std::size_t at) const;
  yaml::Node expected(const yaml::Node& node) const;

  std::string_view text_;
  const yaml::Document& document_;
  TextPlaces places_;
  std::string line_break_;
  std::map<const yaml::Node*, const yaml::Node*> parents_;
  std::vector<Splice> splices_;
  std::map<const yaml::Node*, std::vector<std::string>> appended_;  ///< texts at the end of a map or list
  std::map<const yaml::Node*, yaml::Node> replaced_;
  std::map<const yaml::Node*, std::vector<yaml::Entry>> added_;
  std::map<const yaml::Node*, std::vector<yaml::Node>> added_items_;
  std::set<const void*> removed_;
  std::set<const yaml::Node*> with_removals_;
};

}  // namespace stepwire::language
