#pragma once

#include <string>
#include <vector>

#include "engine/base/yaml/key.hpp"

namespace stepwire::reference {

/// Section of the file format, or a form that occurs many times within a section.
struct Section {
  std::string name;        ///< name for `stepwire format`: "claims"
  std::string definition;  ///< name of its schema definition: "claim"; empty if it has none
  std::string doc;
  yaml::Key form;
  std::string example;  ///< whole file, or an addition to the example of the head
};

/// Returns all sections: the head, the forms that it refers to, and the kinds of plots.
const std::vector<Section>& format_sections();

/// Finds a section by its name or definition; nullptr if unknown.
const Section* find_section(const std::string& name);

}  // namespace stepwire::reference
