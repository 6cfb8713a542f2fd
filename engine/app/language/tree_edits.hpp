#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/app/language/splice.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::language {

/// Changes of a YAML text of which each is noted twice: as splices of the text, and in a tree of what the
/// text is to be. The text is never printed again: comments, quotes, brackets and ends of lines stay as they
/// are. Nodes and entries are those of the document; the text is what it was read from. Both must outlive it.
class TreeEdits {
 public:
  TreeEdits(std::string_view text, const yaml::Document& document);

  /// Puts a value, as a person would write it: "8 kg", "[1, 2]", "max(a, b)". It is put in quotes where the
  /// text around it needs that, or the value had them. All functions throw EditRefused for what is no value
  /// of one line.
  void replace(const yaml::Node& value, const std::string& text);
  /// Adds a key at the end of a map, in the style of the map.
  void add(const yaml::Node& map, const std::string& key, const std::string& text);
  using Keys = std::vector<std::pair<std::string, std::string>>;
  /// The same for a key with a map below it, in the style of the last map of that map.
  void add_map(const yaml::Node& map, const std::string& key, const Keys& keys);
  void add_item(const yaml::Node& list, const std::string& text);
  /// Adds to what a map has under a key: an entry with a name, or without one an item of a list. The key is
  /// begun in lines where it is missing or has no value. A map becomes the first item of the list.
  void add_below(const yaml::Node& map, const std::string& key, const std::string& name,
                 const std::string& text);
  /// Removes a key with its value, and the comment in its last line.
  void remove(const yaml::Node& map, const yaml::Entry& entry);
  void remove_item(const yaml::Node& list, const yaml::Node& item);

  /// The splices, once the text with them was read again. Throws EditRefused where it is not the tree that it
  /// is to be: where an anchor carries a change elsewhere, or the text would be no YAML any more.
  std::vector<Splice> checked() const;
  /// What is to be read from the changed text, but for the places of what is new.
  yaml::Document tree() const { return {document_.file, expected(document_.root)}; }

 private:
  struct Child {
    const void* id;
    TextRange range;  ///< of an entry or an item, without its dash
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
  std::map<const yaml::Node*, yaml::Node> replaced_;
  std::map<const yaml::Node*, std::vector<yaml::Entry>> added_;
  std::map<const yaml::Node*, std::vector<yaml::Node>> added_items_;
  std::set<const void*> removed_;
  std::set<const yaml::Node*> with_removals_;
};

}  // namespace stepwire::language
