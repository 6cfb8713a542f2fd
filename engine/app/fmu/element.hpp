#pragma once

#include <string>
#include <utility>
#include <vector>

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

}  // namespace stepwire::fmu
