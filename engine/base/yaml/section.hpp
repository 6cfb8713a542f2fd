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

/// What the keys of a section are read with: its name in messages, and where faults go. Rooms derive from it
/// what reads their values.
class SectionReading {
 public:
  using Sink = std::function<void(const Mark& mark, const std::string& subject, const Message& message)>;

  SectionReading(std::string subject, Sink sink) : subject(std::move(subject)), sink_(std::move(sink)) {}
  SectionReading(const SectionReading&) = default;
  virtual ~SectionReading() = default;

  std::string subject;  ///< "fit.parameters.mass"

  void fault(const Mark& mark, const Message& message) const { sink_(mark, subject, message); }

  /// Puts what the file has into a member; a fault, and the member stays, where it is not as the key has it.
  void take(const Node& node, const Key& key, std::string& text) const;
  void take(const Node& node, const Key& key, double& number) const;
  void take(const Node& node, const Key& key, std::optional<double>& number) const;
  /// Also the index of a word: a truth or an enum.
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

  /// The text of a scalar, or a fault and "".
  std::string text(const Node& node) const;
  /// The index of the key's word that stands there.
  std::optional<std::size_t> word(const Node& node, const Key& key) const;
  std::optional<double> whole(const Node& node, const Key& key) const;
  /// A number within the key's limits.
  std::optional<double> number(const Node& node, const Key& key) const;
  /// The two items of a list; a fault and nullptr where there are more or fewer.
  const std::vector<Node>* pair(const Node& node, const Key& key) const;

  /// What a key is that is missing: "'view' is missing (what is seen); view: {x: ..}".
  static std::string missing(const Key& key);
  /// Adds a fault for each key of the map that is no key of these, and says whether there was one.
  bool check_unknown(const Node& map, const Key& keys) const;
  /// Gathers what is wrong with the keys of a map: unknown ones, missing ones, those of one choice and those
  /// that stand beside others. Says whether it is a map.
  bool check(const Node& map, const Key& keys) const;

 protected:
  /// A number in SI in the unit of this key; here a plain one.
  virtual std::optional<double> read_number(const Node& node, const Key& key) const;

 private:
  void check_choices(const Node& map, const Key& keys, bool missing_counts) const;
  void check_beside(const Node& map, const Key& keys) const;

  Sink sink_;
};

/// The same for what stands under a key or a name.
template <class Reading>
Reading below(const Reading& read, const std::string& name) {
  Reading inner = read;
  inner.subject += (inner.subject.empty() ? "" : ".") + name;
  return inner;
}

/// What counts in place of a key: the value that the member has without it.
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

/// A row with what it sets. A row without that is read elsewhere, and described here.
template <class Target, class Reading>
struct KeyRow : Key {
  using Set = std::function<void(Target& target, const Node& node, const Reading& read)>;

  KeyRow(std::string name, std::string doc, Key form, Set set = {})
      : Key(stepwire::yaml::key(std::move(name), std::move(doc), std::move(form))), set(std::move(set)) {}

  /// Sets a member, whose type says how it is read; its default is that of a new `Target`.
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

/// The rows of a map as its form.
template <class AnyRow>
Key keys_form(std::string noun, std::string example, const std::vector<AnyRow>& rows) {
  return form::keys(std::move(noun), std::move(example), {rows.begin(), rows.end()});
}

/// Sets what the map has of these rows, in their order.
template <class Target, class Reading>
void set_keys(const Node& map, const std::vector<KeyRow<Target, Reading>>& rows, Target& target,
              const Reading& read) {
  for (const auto& row : rows)
    if (const Node* value = row.set ? map.find(row.name) : nullptr)
      row.set(target, *value, below(read, row.name));
}

/// A map with a reader: what checks it, and the rows that set its target.
template <class Target, class Reading>
struct KeyTable {
  using Row = KeyRow<Target, Reading>;

  std::vector<Row> rows;
  Key form;

  KeyTable(std::string noun, std::string example, std::vector<Row> all)
      : rows(std::move(all)), form(keys_form(std::move(noun), std::move(example), rows)) {}

  /// Says whether it is a map; all that is wrong has gone to the reading's faults.
  bool read(const Node& map, Target& target, const Reading& read) const {
    if (!read.check(map, form)) return false;
    set_keys(map, rows, target, read);
    return true;
  }
};

}  // namespace stepwire::yaml
