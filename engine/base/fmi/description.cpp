#include "engine/base/fmi/description.hpp"

#include <fmt/format.h>

#include <pugixml.hpp>

#include "engine/base/fmi/read_variables.hpp"
#include "engine/base/fmi/unit_error.hpp"

namespace stepwire::fmi {

namespace {

Interface read_interface(const pugi::xml_node& node, int version) {
  Interface read;
  read.identifier = node.attribute("modelIdentifier").value();
  const bool two = version == 2;
  const bool saves = node.attribute(two ? "canGetAndSetFMUstate" : "canGetAndSetFMUState").as_bool();
  read.keeps_state = saves && node.attribute(two ? "canSerializeFMUstate" : "canSerializeFMUState").as_bool();
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
