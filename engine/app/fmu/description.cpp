#include "engine/app/fmu/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "engine/base/fmi/description.hpp"
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

std::string joined(const std::vector<double>& numbers) {
  std::vector<std::string> words;
  for (const double number : numbers) words.push_back(xml_number(number));
  return fmt::format("{}", fmt::join(words, " "));
}

/// True if all names follow the FMI grammar of structured names.
bool structured(const std::vector<Variable>& variables) {
  static const std::regex name(
      R"(([A-Za-z_]\w*(\.[A-Za-z_]\w*)*(\[\d+(,\d+)*\])?)|(der\([A-Za-z_]\w*(\.[A-Za-z_]\w*)*(\[\d+(,\d+)*\])?\)))");
  return std::ranges::all_of(variables,
                             [](const Variable& variable) { return std::regex_match(variable.name, name); });
}

class Writer {
 public:
  Writer(const UnitAbout& about, const std::vector<Variable>& variables)
      : about_(about), variables_(variables), third_(about.version == 3) {}

  Element root() const {
    Element root = head();
    if (about_.exchange) root.add(interface("ModelExchange"));
    root.add(interface("CoSimulation"));
    root.add_filled(unit_definitions(variables_));
    root.add_filled(type_definitions(variables_, about_.version));
    root.add({"LogCategories"})
        .add({"Category"})
        .set("name", "logStatusError")
        .set("description", "what is wrong with a call, or what has ended the run");
    root.add({"DefaultExperiment"})
        .set("startTime", 0.0)
        .set("stopTime", about_.stop)
        .set("stepSize", about_.step);
    if (!third_) add_annotation(root, "VendorAnnotations", "Tool", "name");
    Element& list = root.add({"ModelVariables"});
    for (std::size_t i = 0; i < variables_.size(); ++i) list.add(variable(i));
    root.add(third_ ? structure_of_3() : structure_of_2());
    if (third_) add_annotation(root, "Annotations", "Annotation", "type");
    return root;
  }

 private:
  Element head() const {
    Element root{"fmiModelDescription"};
    root.set("fmiVersion", third_ ? "3.0" : "2.0")
        .set("modelName", about_.name)
        .set(third_ ? "instantiationToken" : "guid", about_.token)
        .set("description", about_.title)
        .set("generationTool", about_.made_by)
        .set("variableNamingConvention", structured(variables_) ? "structured" : "flat");
    if (!third_) root.set("numberOfEventIndicators", std::to_string(about_.exchange ? about_.crossings : 0));
    return root;
  }

  /// Adds an annotation of our own, which the import of the engine reads.
  void add_annotation(Element& root, const char* list, const char* item, const char* key) const {
    if (about_.exchange && about_.smooth)
      root.add({list}).add({item}).set(key, fmi::own_annotation).add({fmi::smooth_element});
  }

  Element interface(const char* kind) const {
    Element element{kind};
    element.set("modelIdentifier", about_.identifier);
    const bool steps = kind == std::string_view("CoSimulation");
    if (steps) element.set("canHandleVariableCommunicationStepSize", "true");
    if (steps && third_) element.set("fixedInternalStepSize", about_.step);
    element.set(third_ ? "canGetAndSetFMUState" : "canGetAndSetFMUstate", "true")
        .set(third_ ? "canSerializeFMUState" : "canSerializeFMUstate", "true")
        .set(third_ ? "providesDirectionalDerivatives" : "providesDirectionalDerivative", "true");
    if (!third_) element.add({"SourceFiles"}).add({"File"}).set("name", about_.source);
    return element;
  }

  /// Sets the attributes of a variable that belong to its type: unit, limits, derivative, start.
  void set_typed(Element& element, const Variable& variable) const {
    const std::string unit = unit_name(variable);
    if (!unit.empty()) element.set("declaredType", type_name(unit)).set("unit", unit);
    if (!variable.shown_in.empty()) element.set("displayUnit", variable.shown_in);
    if (variable.at_least) element.set("min", *variable.at_least);
    if (variable.at_most) element.set("max", *variable.at_most);
    if (variable.derivative_of >= 0)
      element.set("derivative", std::to_string(variable.derivative_of + (third_ ? 0 : 1)));
    if (!variable.start.empty()) element.set("start", joined(variable.start));
  }

  Element variable(std::size_t i) const {
    const Variable& variable = variables_[i];
    Element element{third_ ? "Float64" : "ScalarVariable"};
    element.set("name", variable.name).set("valueReference", std::to_string(i));
    if (!variable.about.empty()) element.set("description", variable.about);
    element.set("causality", variable.causality).set("variability", variable.variability);
    if (variable.causality == "parameter") element.set("initial", "exact");
    if (variable.causality == "output" || variable.causality == "local") element.set("initial", "calculated");
    if (third_) {
      set_typed(element, variable);
      for (const Index size : variable.sizes) element.add({"Dimension"}).set("start", std::to_string(size));
    } else {
      set_typed(element.add({"Real"}), variable);
    }
    return element;
  }

  /// Returns the references of the inputs and states on which a variable depends.
  std::string dependencies(const Variable& variable) const {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      const Variable& known = variables_[i];
      const bool is_known = known.kind == Kind::input || known.kind == Kind::state;
      if (is_known && variable.depends_on.contains(known.block)) words.push_back(number(i));
    }
    return fmt::format("{}", fmt::join(words, " "));
  }
  std::string number(std::size_t i) const { return std::to_string(i + (third_ ? 0 : 1)); }

  Element unknown(const char* name, std::size_t i) const {
    Element element{name};
    element.set(third_ ? "valueReference" : "index", number(i));
    return element;
  }

  template <class Add>
  void each(Kind kind, const Add& add) const {
    for (std::size_t i = 0; i < variables_.size(); ++i)
      if (variables_[i].kind == kind) add(i);
  }

  void add_outputs(Element& to, const char* name) const {
    for (std::size_t i = 0; i < variables_.size(); ++i)
      if (variables_[i].causality == "output")
        to.add(unknown(name, i)).set("dependencies", dependencies(variables_[i]));
  }
  void add_slopes(Element& to, const char* name) const {
    each(Kind::slope,
         [&](std::size_t i) { to.add(unknown(name, i)).set("dependencies", dependencies(variables_[i])); });
  }
  void add_initial(Element& to, const char* name) const {
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      const Kind kind = variables_[i].kind;
      if (variables_[i].causality == "output" || kind == Kind::state || kind == Kind::slope)
        to.add(unknown(name, i));
    }
  }

  Element structure_of_3() const {
    Element structure{"ModelStructure"};
    add_outputs(structure, "Output");
    add_slopes(structure, "ContinuousStateDerivative");
    add_initial(structure, "InitialUnknown");
    each(Kind::indicator, [&](std::size_t i) { structure.add(unknown("EventIndicator", i)); });
    return structure;
  }

  Element structure_of_2() const {
    Element structure{"ModelStructure"}, outputs{"Outputs"}, slopes{"Derivatives"},
        initial{"InitialUnknowns"};
    add_outputs(outputs, "Unknown");
    add_slopes(slopes, "Unknown");
    add_initial(initial, "Unknown");
    for (Element* one : {&outputs, &slopes, &initial}) structure.add_filled(std::move(*one));
    return structure;
  }

  const UnitAbout& about_;
  const std::vector<Variable>& variables_;
  bool third_;
};

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

std::string description_text(const UnitAbout& about, const std::vector<Variable>& variables) {
  return xml_text(Writer(about, variables).root());
}

}  // namespace stepwire::fmu
