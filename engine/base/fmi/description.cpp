#include "engine/base/fmi/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>

#include "engine/base/fmi/unit_error.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::fmi {

namespace {

/// A unit of a description, converted to the unit of a port.
struct ScaledUnit {
  std::string name = "*";             ///< the SI unit, or "*" if unknown
  double factor = 1.0, offset = 0.0;  ///< value_si = offset + factor * value
};

/// Units of a description by their names.
using UnitTable = std::map<std::string, ScaledUnit>;

/// Exponents of a BaseUnit, by the names of its attributes: kg, m, s, A, K, mol, cd, rad.
using BaseExponents = std::map<std::string, int>;

/// Returns the unit of a product of base units.
ScaledUnit base_unit(const BaseExponents& exponents, double factor, double offset) {
  std::string product;
  for (const auto& [base, exponent] : exponents)
    if (exponent != 0) product += fmt::format("{}{}^{}", product.empty() ? "" : " ", base, exponent);
  const auto unit = unit::parse_unit(product);
  return {unit ? unit::si_name(unit->dimension) : "*", factor, offset};
}

/// Returns the unit of a bare unit name: an SI unit that our own export writes, or unknown.
ScaledUnit named_unit(const std::string& name) {
  const auto unit = unit::parse_unit(name);
  if (!unit) return {};
  return {unit::si_name(unit->dimension), static_cast<double>(unit->scale),
          static_cast<double>(unit->offset)};
}

const std::map<std::string, Type>& types(int version) {
  static const std::map<std::string, Type> two{{"Real", Type::float64},
                                               {"Integer", Type::int32},
                                               {"Enumeration", Type::int32},
                                               {"Boolean", Type::wide_boolean},
                                               {"String", Type::other}};
  static const std::map<std::string, Type> three{
      {"Float64", Type::float64}, {"Float32", Type::float32},   {"Int8", Type::int8},
      {"UInt8", Type::uint8},     {"Int16", Type::int16},       {"UInt16", Type::uint16},
      {"Int32", Type::int32},     {"UInt32", Type::uint32},     {"Int64", Type::int64},
      {"UInt64", Type::uint64},   {"Enumeration", Type::int64}, {"Boolean", Type::boolean},
      {"String", Type::other},    {"Binary", Type::other},      {"Clock", Type::other}};
  return version == 2 ? two : three;
}

UnitTable read_units(const pugi::xml_node& root) {
  UnitTable units;
  for (const pugi::xml_node& node : root.child("UnitDefinitions").children("Unit")) {
    const std::string name = node.attribute("name").value();
    const pugi::xml_node base = node.child("BaseUnit");
    BaseExponents exponents;
    for (const char* key : {"kg", "m", "s", "A", "K", "mol", "cd", "rad"})
      exponents[key] = base.attribute(key).as_int();
    units[name] = base ? base_unit(exponents, base.attribute("factor").as_double(1.0),
                                   base.attribute("offset").as_double(0.0))
                       : named_unit(name);
  }
  return units;
}

/// Declared types by name; their attributes are default units and limits.
using DeclaredTypes = std::map<std::string, pugi::xml_node>;

DeclaredTypes read_types(const pugi::xml_node& root, int version) {
  DeclaredTypes declared;
  for (const pugi::xml_node& node : root.child("TypeDefinitions").children())
    declared[node.attribute("name").value()] = version == 2 ? node.first_child() : node;
  return declared;
}

std::string port_name(const std::string& name) {
  std::string port;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') {
      port += c;
    } else if (!port.empty() && port.back() != '_') {
      port += '_';
    }
  while (port.size() > 1 && port.back() == '_') port.pop_back();
  if (port.empty() || std::isdigit(static_cast<unsigned char>(port[0]))) port = "_" + port;
  return port;
}

Causality causality_of(const std::string& word) {
  static const std::map<std::string, Causality> words{{"parameter", Causality::parameter},
                                                      {"calculatedParameter", Causality::calculated},
                                                      {"input", Causality::input},
                                                      {"output", Causality::output},
                                                      {"independent", Causality::independent},
                                                      {"structuralParameter", Causality::structural}};
  const auto found = words.find(word);
  return found == words.end() ? Causality::local : found->second;
}

constexpr std::size_t most_numbers = 10'000'000;

/// Reader of the variables, in their order.
class Reader {
 public:
  Reader(const pugi::xml_node& root, Description& into)
      : root_(root), into_(into), units_(read_units(root)), declared_(read_types(root, into.version)) {}

  void read() {
    for (const pugi::xml_node& node : root_.child("ModelVariables").children())
      if (into_.version == 2) {
        for (const pugi::xml_node& inner : node.children())
          if (types(2).contains(inner.name())) add(node, inner);
      } else if (types(3).contains(node.name())) {
        add(node, node);
      }
    read_structure();
  }

 private:
  void add(const pugi::xml_node& node, const pugi::xml_node& typed) {
    Variable variable;
    variable.name = node.attribute("name").value();
    variable.description = node.attribute("description").value();
    variable.port = port_name(variable.name);
    variable.reference = node.attribute("valueReference").as_uint();
    variable.type = types(into_.version).at(typed.name());
    variable.causality = causality_of(node.attribute("causality").value());
    const std::string variability = node.attribute("variability").value();
    const bool real = variable.type == Type::float64 || variable.type == Type::float32;
    variable.discrete = variability == "discrete" || (variability.empty() && !real);
    variable.constant = variability == "constant";
    const std::string initial = node.attribute("initial").value();
    const bool has_start = typed.attribute("start") || typed.child("Start");
    variable.starts_exact = has_start && initial != "calculated" && !variable.constant &&
                            variable.causality != Causality::independent;
    take_unit(variable, typed, real);
    if (is_port(variable) && !names_.insert(variable.port).second)
      throw UnitError(fmt::format("two of its variables would be called '{}' as ports; '{}' is one of them",
                                  variable.port, variable.name));
    into_.places.try_emplace(variable.reference, nodes_.size());
    if (const auto state = node.attribute("derivative"); state && into_.version == 3)
      states_.try_emplace(variable.reference, state.as_uint());
    nodes_.push_back(node);
    into_.variables.push_back(std::move(variable));
  }

  static bool is_port(const Variable& variable) {
    return variable.causality == Causality::input || variable.causality == Causality::output;
  }

  /// Returns an attribute of the variable, else that of its declared type.
  pugi::xml_attribute attribute(const pugi::xml_node& typed, const char* name) const {
    if (const auto own = typed.attribute(name)) return own;
    const auto type = declared_.find(typed.attribute("declaredType").value());
    return type == declared_.end() ? pugi::xml_attribute() : type->second.attribute(name);
  }

  void take_unit(Variable& variable, const pugi::xml_node& typed, bool real) {
    const std::string name = attribute(typed, "unit").value();
    if (real && !name.empty()) {
      const auto known = units_.find(name);
      const ScaledUnit unit = known == units_.end() ? named_unit(name) : known->second;
      variable.unit = unit.name;
      variable.factor = unit.factor;
      variable.offset = attribute(typed, "relativeQuantity").as_bool() ? 0.0 : unit.offset;
    }
    const auto si = [&](const pugi::xml_attribute& limit) -> std::optional<double> {
      if (!limit) return {};
      return variable.offset + variable.factor * limit.as_double();
    };
    variable.at_least = si(attribute(typed, "min"));
    variable.at_most = si(attribute(typed, "max"));
  }

  /// Reads the sizes of arrays; a size may be the value of a structural parameter.
  void take_sizes() {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (const pugi::xml_node& dimension : nodes_[i].children("Dimension"))
        into_.variables[i].size =
            std::min(into_.variables[i].size, most_numbers + 1) * dimension_of(dimension);
  }
  std::size_t dimension_of(const pugi::xml_node& dimension) const {
    if (const auto start = dimension.attribute("start")) return start.as_uint();
    const unsigned reference = dimension.attribute("valueReference").as_uint();
    if (const auto place = into_.places.find(reference); place != into_.places.end())
      return nodes_[place->second].attribute("start").as_uint();
    throw UnitError(fmt::format("a dimension names the variable {}, which is not there", reference));
  }

  void read_structure() {
    take_sizes();
    const pugi::xml_node structure = root_.child("ModelStructure");
    into_.version == 2 ? read_second(structure) : read_third(structure);
    gather_feeding();
    for (std::uint32_t reference : into_.states) {
      const Variable* state = into_.find(reference);
      if (!state) throw UnitError(fmt::format("its state {} is no variable", reference));
      into_.state_count += state->size;
    }
    require_few();
  }

  /// Throws UnitError for more numbers than any memory holds; a few bytes of text can announce them.
  void require_few() const {
    std::size_t most = std::max(into_.state_count, into_.indicator_count);
    for (const Variable& variable : into_.variables) most = std::max(most, variable.size);
    if (most > most_numbers)
      throw UnitError(
          fmt::format("a variable, its states or its event indicators have {} numbers, and may have {}", most,
                      most_numbers));
  }

  void read_third(const pugi::xml_node& structure) {
    for (const pugi::xml_node& node : structure.children("Output")) depend(node, "valueReference");
    for (const pugi::xml_node& node : structure.children("ContinuousStateDerivative"))
      add_state(node.attribute("valueReference").as_uint());
    for (const pugi::xml_node& node : structure.children("EventIndicator")) {
      const Variable* indicator = into_.find(node.attribute("valueReference").as_uint());
      into_.indicator_count += indicator ? indicator->size : 1;
    }
  }
  void add_state(std::uint32_t derivative) {
    into_.derivatives.push_back(derivative);
    if (const auto state = states_.find(derivative); state != states_.end())
      return into_.states.push_back(state->second);
    throw UnitError(fmt::format("its derivative {} does not say of which state it is", derivative));
  }

  /// Returns the index of a variable; FMI 2 refers to variables by their position from 1.
  std::size_t at_place(unsigned place) const {
    if (place < 1 || place > nodes_.size())
      throw UnitError(fmt::format("its ModelStructure names the variable {} of {}", place, nodes_.size()));
    return place - 1;
  }
  void read_second(const pugi::xml_node& structure) {
    for (const pugi::xml_node& node : structure.child("Outputs").children("Unknown")) depend(node, "index");
    for (const pugi::xml_node& node : structure.child("Derivatives").children("Unknown")) {
      const std::size_t derivative = at_place(node.attribute("index").as_uint());
      const unsigned state = nodes_[derivative].child("Real").attribute("derivative").as_uint();
      into_.derivatives.push_back(into_.variables[derivative].reference);
      into_.states.push_back(into_.variables[at_place(state)].reference);
    }
    into_.indicator_count = root_.attribute("numberOfEventIndicators").as_uint();
  }

  void depend(const pugi::xml_node& node, const char* key) {
    if (!node.attribute("dependencies")) return;
    const auto reference = [&](unsigned number) {
      return into_.version == 2 ? into_.variables[at_place(number)].reference : number;
    };
    const auto [known, is_new] = depending_.try_emplace(reference(node.attribute(key).as_uint()));
    std::istringstream list(node.attribute("dependencies").value());
    for (unsigned number = 0; list >> number;) {
      const std::uint32_t on = reference(number);
      if (is_new) known->second.push_back(on);
    }
  }

  void gather_feeding() {
    into_.feeding.emplace();
    for (const Variable& output : into_.variables) {
      if (output.causality != Causality::output) continue;
      const auto known = depending_.find(output.reference);
      if (known == depending_.end()) return into_.feeding.reset();
      into_.feeding->insert(known->second.begin(), known->second.end());
    }
  }

  pugi::xml_node root_;
  Description& into_;
  UnitTable units_;
  DeclaredTypes declared_;
  std::vector<pugi::xml_node> nodes_;                        ///< elements of the variables
  std::set<std::string> names_;                              ///< of the ports
  std::unordered_map<std::uint32_t, std::uint32_t> states_;  ///< state of each derivative, in FMI 3
  /// Variables that each output depends on.
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> depending_;
};

/// Reads units, types, variables and model structure into a description whose version is set. Throws
/// UnitError.
void read_variables(const pugi::xml_node& root, Description& description) {
  Reader(root, description).read();
}

Interface read_interface(const pugi::xml_node& node, int version) {
  Interface read;
  read.identifier = node.attribute("modelIdentifier").value();
  const bool two = version == 2;
  const bool saves = node.attribute(two ? "canGetAndSetFMUstate" : "canGetAndSetFMUState").as_bool();
  read.keeps_state = saves && node.attribute(two ? "canSerializeFMUstate" : "canSerializeFMUState").as_bool();
  if (const double step = node.attribute("fixedInternalStepSize").as_double(); std::isfinite(step))
    read.internal_step = std::max(0.0, step);
  read.only_once = node.attribute("canBeInstantiatedOnlyOncePerProcess").as_bool();
  read.needs_tool = node.attribute("needsExecutionTool").as_bool();
  return read;
}

bool is_identifier(const std::string& text) {
  return text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") ==
         text.npos;
}

int read_version(const pugi::xml_node& root) {
  const std::string version = root.attribute("fmiVersion").value();
  if (version == "2.0") return 2;
  if (version == "3.0" || version.starts_with("3.0.")) return 3;
  throw UnitError(
      fmt::format("its modelDescription.xml has fmiVersion \"{}\"; versions 2.0 and 3.0 are read", version));
}

}  // namespace

const Variable* Description::find(std::uint32_t reference) const {
  const auto place = places.find(reference);
  return place == places.end() ? nullptr : &variables[place->second];
}

bool Description::feeds_through(const Variable& input) const {
  return !feeding || feeding->contains(input.reference);
}

Description read_description(const std::string& xml) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(xml.data(), xml.size());
  if (!result)
    throw UnitError(fmt::format("its modelDescription.xml is no XML: {} at byte {}", result.description(),
                                result.offset));
  const pugi::xml_node root = document.child("fmiModelDescription");
  if (!root) throw UnitError("its modelDescription.xml has no fmiModelDescription");
  Description read;
  read.version = read_version(root);
  read.name = root.attribute("modelName").value();
  read.token = root.attribute(read.version == 2 ? "guid" : "instantiationToken").value();
  read.co_simulation = read_interface(root.child("CoSimulation"), read.version);
  read.model_exchange = read_interface(root.child("ModelExchange"), read.version);
  for (const Interface* one : {&read.co_simulation, &read.model_exchange})
    if (!is_identifier(one->identifier))
      throw UnitError(fmt::format("its modelIdentifier '{}' is no name of C", one->identifier));
  if (read.co_simulation.identifier.empty() && read.model_exchange.identifier.empty())
    throw UnitError("it has neither CoSimulation nor ModelExchange; scheduled execution is not run");
  const pugi::xml_node own =
      read.version == 2 ? root.child("VendorAnnotations").find_child_by_attribute("name", own_annotation)
                        : root.child("Annotations").find_child_by_attribute("type", own_annotation);
  read.smooth = !own.child(smooth_element).empty();
  read_variables(root, read);
  return read;
}

}  // namespace stepwire::fmi
