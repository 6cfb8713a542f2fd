#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/model/diagram/load.hpp"

namespace stepwire {

/// The keys of a section that may be like that of another file, each with the file in which it stands.
class SectionKeys {
 public:
  struct Key {
    std::string name, file;
    Mark mark;
    const Node* node;
  };

  /// Takes the keys of `node`, the section `section` of `file`, then those of the file that its key `like`
  /// names which are not yet there, and so on. What is wrong goes to `faults`.
  SectionKeys(const std::string& section, const Node& node, const std::string& file,
              const std::vector<std::string>& known, Loader& loader, Faults& faults);

  const Key* find(const std::string& name) const;
  /// The same; a fault with the form that the key has where it is missing.
  const Key* required(const std::string& name, const std::string& form);
  /// A whole number, or a fault and what it is otherwise.
  std::uint64_t whole(const std::string& name, double least, double most, std::uint64_t otherwise);
  static std::optional<std::size_t> whole(const Node& node, double least, double most);

  void fault(const Key& key, const std::string& message) { fault(key, key.node->mark, "", message); }
  /// At a place inside of the key's value, which has the name `below` there.
  void fault(const Key& key, const Mark& mark, const std::string& below, const std::string& message);
  /// About the section as a whole.
  void fault(const std::string& message);

 private:
  void take(const Node& node, const std::string& file);
  void take_from(const Node& like, const std::string& file);
  void add(const std::string& file, const Mark& mark, const std::string& subject, const std::string& message);

  std::string section_;
  Place place_;
  const std::vector<std::string>& known_;
  Loader& loader_;
  Faults& faults_;
  std::set<std::string> files_;
  std::vector<Key> keys_;
};

}  // namespace stepwire
