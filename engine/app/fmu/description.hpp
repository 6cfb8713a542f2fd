#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/app/fmu/variables.hpp"

namespace stepwire::fmu {

/// XML element. Names, values and texts are escaped on output.
struct Element {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes{};
  std::vector<Element> children{};

  Element& set(const std::string& attribute, std::string value);
  Element& set(const std::string& attribute, double value);
  /// Adds a child and returns it. The reference is valid until the next child is added.
  Element& add(Element child);
  /// Adds the child unless it is empty.
  void add_filled(Element child);
};

/// Returns an XML document with this root.
std::string xml_text(const Element& root);

/// Returns a number in XML notation, the shortest that reads back to the same bits.
std::string xml_number(double value);

/// Returns the unit name of a variable in the description; empty if its dimension is unknown.
std::string unit_name(const Variable& variable);

/// Returns the name of the type of all variables with this unit. It contains a space, so it differs from all
/// variable names.
std::string type_name(const std::string& unit);

/// Returns UnitDefinitions: units of the variables as powers of SI base units, and the units of the file as
/// display units.
Element unit_definitions(const std::vector<Variable>& variables);

/// Returns TypeDefinitions, one type for each unit.
Element type_definitions(const std::vector<Variable>& variables, int version);

/// Content of a model description except its variables.
struct UnitAbout {
  int version = 3;         ///< major version of FMI
  std::string name;        ///< name of the model
  std::string identifier;  ///< model identifier, the name of the binary
  std::string title, made_by;
  std::string token;
  std::string source;  ///< file name of the compiled source; unlike that of the diagram's source it is no C++
                       ///< identifier
  double step = 0.0, stop = 0.0;
  bool exchange = false;
  std::size_t crossings = 0;
  bool smooth = false;  ///< true if no source in the diagram can jump
};

/// Returns modelDescription.xml of FMI 3 or FMI 2. The variables must be those of that version.
std::string description_text(const UnitAbout& about, const std::vector<Variable>& variables);

}  // namespace stepwire::fmu
