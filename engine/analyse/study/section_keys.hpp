#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/base/yaml/section.hpp"
#include "engine/model/diagram/load.hpp"

namespace stepwire {

/// The keys of a section that may be like that of another file, each with the file in which it stands.
class SectionKeys {
 public:
  struct Given {
    std::string name, file;
    Mark mark;
    const Node* node;
  };

  /// Takes the keys of `node`, the section `section` of `file`, then those of the file that its key `like`
  /// names which are not yet there, and so on. What is no key of `form`, or wrong otherwise, goes to
  /// `faults`.
  SectionKeys(const std::string& section, const Node& node, const std::string& file, const Key& form,
              Loader& loader, Faults& faults);

  const Given* find(const std::string& name) const;
  const std::vector<Given>& all() const { return keys_; }

 private:
  void take(const Node& node, const std::string& file);
  void take_from(const Node& like, const std::string& file);
  SectionReading reading(const std::string& file) const;

  std::string section_;
  const Key& form_;
  Loader& loader_;
  Faults& faults_;
  std::set<std::string> files_;
  std::vector<Given> keys_;
};

}  // namespace stepwire
