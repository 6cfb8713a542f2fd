#pragma once

#include <string>
#include <utility>
#include <vector>

namespace stepwire::fmu {

/// An element of XML. Texts may be any; what XML refuses of them is escaped as it is written.
struct Element {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes{};
  std::vector<Element> children{};

  Element& set(const std::string& attribute, std::string value);
  Element& set(const std::string& attribute, double value);
  /// Adds a child, and returns it for as long as no other is added.
  Element& add(Element child);
  /// Adds it unless it is empty.
  void add_filled(Element child);
};

/// A document with this root.
std::string xml_text(const Element& root);

/// A number as XML has it: the shortest that reads back to the same bits.
std::string xml_number(double value);

}  // namespace stepwire::fmu
