#pragma once

#include <string>
#include <vector>

#include "engine/base/yaml/key.hpp"

namespace stepwire::reference {

/// A section of the format, or what stands in one many times.
struct Section {
  std::string name;        ///< as `stepwire format` takes it: "claims"
  std::string definition;  ///< in the schema, which other sections refer to: "claim"; empty: it has none
  std::string doc;
  yaml::Key form;
  std::string example;  ///< a file, or what is added to the example of the head
};

/// All of them: the head, what it refers to, and the kinds of plots.
const std::vector<Section>& format_sections();

/// The section of a name or of a definition, or nullptr.
const Section* find_section(const std::string& name);

}  // namespace stepwire::reference
