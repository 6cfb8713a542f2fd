#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/base/yaml/section.hpp"
#include "engine/model/diagram/load.hpp"

namespace stepwire::study {

/// Keys of a section that can inherit from another file (`like`), each with its own file.
class SectionKeys {
 public:
  struct Given {
    std::string name, file;
    yaml::Mark mark;
    const yaml::Node* node;
  };

  /// Collects the keys of `node`, the section `section` of `file`. Then it adds the missing ones from the
  /// file that its key `like` names, and so on. Adds faults for keys that are not in `form`.
  SectionKeys(const std::string& section, const yaml::Node& node, const std::string& file,
              const yaml::Key& form, diagram::Loader& loader, yaml::Faults& faults);

  const Given* find(const std::string& name) const;
  const std::vector<Given>& all() const { return keys_; }

 private:
  void take(const yaml::Node& node, const std::string& file);
  void take_from(const yaml::Node& like, const std::string& file);
  yaml::SectionReading reading(const std::string& file) const;

  std::string section_;
  const yaml::Key& form_;
  diagram::Loader& loader_;
  yaml::Faults& faults_;
  std::set<std::string> files_;
  std::vector<Given> keys_;
};

}  // namespace stepwire::study
