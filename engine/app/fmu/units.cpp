#include "engine/app/fmu/units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

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

struct UsedUnit {
  unit::Dimension dimension;
  std::set<std::string> shown_in;
};

std::map<std::string, UsedUnit> units_of(const std::vector<Variable>& variables) {
  std::map<std::string, UsedUnit> units;
  for (const Variable& variable : variables) {
    if (!variable.dimension) continue;
    UsedUnit& used = units[unit_name(variable)];
    used.dimension = *variable.dimension;
    if (!variable.shown_in.empty()) used.shown_in.insert(variable.shown_in);
  }
  return units;
}

bool is_whole(double exponent) {
  return exponent == std::round(exponent);
}

/// Adds the SI base units of a dimension, unless it has a fractional exponent, which FMI cannot express.
void add_base_unit(Element& to, const unit::Dimension& dimension) {
  constexpr const char* names[] = {"m", "kg", "s", "A", "K", "mol", "cd"};
  Element base{"BaseUnit"};
  for (std::size_t i = 0; i < dimension.exponents.size(); ++i) {
    if (!is_whole(dimension.exponents[i])) return;
    if (dimension.exponents[i] != 0.0) base.set(names[i], dimension.exponents[i]);
  }
  if (dimension.angle != 0.0 && is_whole(dimension.angle)) base.set("rad", dimension.angle);
  to.add(std::move(base));
}

/// Returns a display unit. FMI computes: shown = factor * value + offset.
Element display_unit(const std::string& name) {
  const unit::Unit unit = *unit::parse_unit(name);
  Element display{"DisplayUnit"};
  display.set("name", name).set("factor", static_cast<double>(1.0L / unit.scale));
  if (unit.offset != 0.0L) display.set("offset", static_cast<double>(-unit.offset / unit.scale));
  return display;
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

std::string unit_name(const Variable& variable) {
  return variable.dimension ? unit::si_name(*variable.dimension) : "";
}

std::string type_name(const std::string& unit) {
  return "in " + unit;
}

Element unit_definitions(const std::vector<Variable>& variables) {
  Element definitions{"UnitDefinitions"};
  for (const auto& [name, used] : units_of(variables)) {
    Element& one = definitions.add({"Unit"});
    one.set("name", name);
    add_base_unit(one, used.dimension);
    for (const std::string& shown : used.shown_in) one.add(display_unit(shown));
  }
  return definitions;
}

Element type_definitions(const std::vector<Variable>& variables, int version) {
  Element definitions{"TypeDefinitions"};
  for (const auto& [name, used] : units_of(variables)) {
    if (version == 3) {
      definitions.add({"Float64Type"}).set("name", type_name(name)).set("unit", name);
    } else {
      Element& type = definitions.add({"SimpleType"});
      type.set("name", type_name(name)).add({"Real"}).set("unit", name);
    }
  }
  return definitions;
}

}  // namespace stepwire::fmu
