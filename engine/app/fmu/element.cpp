#include "engine/app/fmu/element.hpp"

#include <fmt/format.h>

#include "engine/view/svg/svg.hpp"

namespace stepwire::fmu {

namespace {

void append(std::string& text, const Element& element, std::size_t depth) {
  text += std::string(2 * depth, ' ') + "<" + element.name;
  for (const auto& [name, value] : element.attributes)
    text += fmt::format(" {}=\"{}\"", name, svg::markup_escaped(value));
  text += element.children.empty() ? "/>\n" : ">\n";
  for (const Element& child : element.children) append(text, child, depth + 1);
  if (!element.children.empty()) text += std::string(2 * depth, ' ') + "</" + element.name + ">\n";
}

}  // namespace

Element& Element::set(const std::string& attribute, std::string value) {
  attributes.emplace_back(attribute, std::move(value));
  return *this;
}

Element& Element::set(const std::string& attribute, double value) {
  return set(attribute, xml_number(value));
}

Element& Element::add(Element child) {
  children.push_back(std::move(child));
  return children.back();
}

void Element::add_filled(Element child) {
  if (!child.children.empty()) add(std::move(child));
}

std::string xml_text(const Element& root) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  append(text, root, 0);
  return text;
}

std::string xml_number(double value) {
  return fmt::format("{}", value);
}

}  // namespace stepwire::fmu
