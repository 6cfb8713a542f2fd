#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/base/yaml/key.hpp"

namespace stepwire::yaml {

/// Context for reading the keys of a section: its name in messages, and the sink of faults. Other rooms
/// derive readers of their values from it.
class SectionReading {
 public:
  using Sink = std::function<void(const Mark& mark, const std::string& subject, const Message& message)>;

  SectionReading(std::string subject, Sink sink) : subject(std::move(subject)), sink_(std::move(sink)) {}
  SectionReading(const SectionReading&) = default;
  virtual ~SectionReading() = default;

  std::string subject;  ///< name in messages, "fit.parameters.mass"

  void fault(const Mark& mark, const Message& message) const { sink_(mark, subject, message); }

  /// Reads a value of the key's form into a member. An invalid value adds a fault and leaves the member
  /// unchanged.
  void take(const Node& node, const Key& key, std::string& text) const;
  void take(const Node& node, const Key& key, double& number) const;
  void take(const Node& node, const Key& key, std::optional<double>& number) const;
  /// Reads a whole number, or the index of a word for a bool or an enum.
  template <class Member>
  requires std::integral<Member> || std::is_enum_v<Member>
  void take(const Node& node, const Key& key, Member& member) const {
    if (key.form != Key::Form::whole) {
      if (const auto index = word(node, key)) member = static_cast<Member>(*index);
    } else if (const auto value = whole(node, key)) {
      member = static_cast<Member>(*value);
    }
  }
  template <class Member>
  requires std::integral<Member>
  void take(const Node& node, const Key& key, std::optional<Member>& member) const {
    if (const auto value = whole(node, key)) member = static_cast<Member>(*value);
  }

  /// Returns the text of a scalar; adds a fault and returns "" for another value.
  std::string text(const Node& node) const;
  /// Returns the index of the value among the key's words; adds a fault and returns std::nullopt for other
  /// values.
  std::optional<std::size_t> word(const Node& node, const Key& key) const;
  std::optional<double> whole(const Node& node, const Key& key) const;
  /// Returns a number within the key's limits.
  std::optional<double> number(const Node& node, const Key& key) const;
  /// Returns the two items of a list; adds a fault and returns nullptr for another length.
  const std::vector<Node>* pair(const Node& node, const Key& key) const;

  /// Returns the message for a missing key: "'view' is missing (what is seen); view: {x: ..}".
  static std::string missing(const Key& key);
  /// Adds a fault for each unknown key of the map. Returns true if there was one.
  bool check_unknown(const Node& map, const Key& keys) const;
  /// Adds the faults of the keys of a map: unknown and missing keys, groups of alternatives, and required
  /// companions. Returns false where the node is not a map.
  bool check(const Node& map, const Key& keys) const;

 protected:
  /// Returns a number in SI, read in the unit of the key. The base class reads plain numbers only.
  virtual std::optional<double> read_number(const Node& node, const Key& key) const;

 private:
  void check_choices(const Node& map, const Key& keys, bool missing_counts) const;
  void check_beside(const Node& map, const Key& keys) const;

  Sink sink_;
};

/// Returns the context of a key or name inside of this section.
template <class Reading>
Reading below(const Reading& read, const std::string& name) {
  Reading inner = read;
  inner.subject += (inner.subject.empty() ? "" : ".") + name;
  return inner;
}

/// Returns the default of a member as text for the documentation.
std::string default_text(const Key& key, double value);
template <class Member>
std::string default_text(const Key& key, const Member& value) {
  if constexpr (std::is_same_v<Member, std::string>)
    return value;
  else if constexpr (std::is_enum_v<Member> || std::is_same_v<Member, bool>)
    return key.words.at(static_cast<std::size_t>(value)).word;
  else if constexpr (std::integral<Member>)
    return key.words.empty() ? std::to_string(value) : key.words.at(static_cast<std::size_t>(value)).word;
  else
    return {};
}

/// A key with the function that sets its target. A row without a function is only documented here and read
/// elsewhere.
template <class Target, class Reading>
struct KeyRow : Key {
  using Set = std::function<void(Target& target, const Node& node, const Reading& read)>;

  KeyRow(std::string name, std::string doc, Key form, Set set = {})
      : Key(stepwire::yaml::key(std::move(name), std::move(doc), std::move(form))), set(std::move(set)) {}

  /// Makes a row that sets a member; its type determines the reading. The default is that of a new `Target`.
  template <class Member>
  KeyRow(std::string name, std::string doc, Key form, Member Target::*member)
      : Key(stepwire::yaml::key(std::move(name), std::move(doc), std::move(form))) {
    otherwise = default_text(*this, Target{}.*member);
    set = [member, row = static_cast<Key>(*this)](Target& target, const Node& node, const Reading& read) {
      read.take(node, row, target.*member);
    };
  }

  Set set;
};

/// Returns the form of a map with these rows as its keys.
template <class AnyRow>
Key keys_form(std::string noun, std::string example, const std::vector<AnyRow>& rows) {
  return form::keys(std::move(noun), std::move(example), {rows.begin(), rows.end()});
}

/// Sets the members of all rows whose keys the map has, in the order of the rows.
template <class Target, class Reading>
void set_keys(const Node& map, const std::vector<KeyRow<Target, Reading>>& rows, Target& target,
              const Reading& read) {
  for (const auto& row : rows)
    if (const Node* value = row.set ? map.find(row.name) : nullptr)
      row.set(target, *value, below(read, row.name));
}

/// Reader of a map: its form, for checks, and the rows that set its target.
template <class Target, class Reading>
struct KeyTable {
  using Row = KeyRow<Target, Reading>;

  std::vector<Row> rows;
  Key form;

  KeyTable(std::string noun, std::string example, std::vector<Row> all)
      : rows(std::move(all)), form(keys_form(std::move(noun), std::move(example), rows)) {}

  /// Checks and reads a map; faults are added to the context. Returns false where the node is not a map.
  bool read(const Node& map, Target& target, const Reading& read) const {
    if (!read.check(map, form)) return false;
    set_keys(map, rows, target, read);
    return true;
  }
};

}  // namespace stepwire::yaml
