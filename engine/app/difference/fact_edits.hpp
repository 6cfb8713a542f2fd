#pragma once

#include <string>

#include "engine/app/difference/facts.hpp"
#include "engine/app/language/tree_edits.hpp"

namespace stepwire::difference {

/// Edits of a text by facts of another text. A text that cannot take a value is refused at the end, by
/// text().
class FactEdits {
 public:
  /// Edits the text `into`; values come from the text `from`. Both must outlive the object.
  FactEdits(const DiagramText& into, const DiagramText& from);

  /// True where the fact is a map, or a list, in the text as well, and not a short form of it.
  bool is_map(const Fact& fact) const { return fact.node && fact.node->is_map(); }
  bool is_list(const Fact& fact) const { return fact.node && fact.node->is_list(); }

  void replace(const Fact& fact, const Fact& by);
  void add(const Fact& map, const Fact& part);
  void add_item(const Fact& list, const Fact& item);
  void remove(const Fact& map, const Fact& part);
  void remove_item(const Fact& list, const Fact& item);

  /// Returns the edited text with a line end. Throws EditRefused with the reason of the first refusal.
  std::string text() const;

 private:
  template <class Edit>
  void attempt(Edit edit);
  std::string written(const Fact& fact) const;
  std::string section_text(const yaml::Entry& section) const;

  const DiagramText& into_;
  const DiagramText& from_;
  language::TextPlaces from_places_, places_;
  language::TreeEdits edits_;
  std::string appended_;  ///< new sections, in lines
  std::string refusal_;   ///< reason of the first refused edit; empty without one
};

}  // namespace stepwire::difference
