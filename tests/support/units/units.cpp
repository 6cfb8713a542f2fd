#include "tests/support/units/units.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace stepwire::testing {

namespace {

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

const std::map<std::string, std::string> variables{
    {"dahlquist",
     R"xml(<Float64 name="x" valueReference="1" causality="output" initial="exact" start="1"/>
<Float64 name="der(x)" valueReference="2" derivative="1"/>
<Float64 name="k" valueReference="3" causality="parameter" variability="tunable" start="1" min="0" max="100" unit="1/s"/>
<Float64 name="shown [mm]" valueReference="1" causality="output" unit="mm"/>)xml"},
    {"ball",
     R"xml(<Float64 name="h" valueReference="1" causality="output" initial="exact" start="1" unit="m"/>
<Float64 name="der(h)" valueReference="2" derivative="1" unit="m/s"/>
<Float64 name="v" valueReference="3" causality="output" initial="exact" start="0" unit="m/s"/>
<Float64 name="der(v)" valueReference="4" derivative="3"/>
<Float64 name="e" valueReference="5" causality="parameter" start="0.7"/>
<Float64 name="z" valueReference="7"/>)xml"},
    {"stair",
     R"xml(<Int32 name="counter" valueReference="1" causality="output" initial="exact" start="1"/>)xml"},
    {"fails", R"xml(<Float64 name="y" valueReference="1" causality="output"/>)xml"},
    {"crashes", R"xml(<Float64 name="y" valueReference="1" causality="output"/>)xml"}};

const std::map<std::string, std::string> structure{
    {"dahlquist", R"xml(<ContinuousStateDerivative valueReference="2"/>)xml"},
    {"ball",
     R"xml(<ContinuousStateDerivative valueReference="2"/><ContinuousStateDerivative valueReference="4"/>
<EventIndicator valueReference="7"/>)xml"}};

std::string feedthrough_variables() {
  std::string text;
  int reference = 0;
  for (const char* type : {"Float64", "Float32", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32",
                           "Int64", "UInt64", "Boolean"}) {
    ++reference;
    text += fmt::format("<{0} name=\"{0}_input\" valueReference=\"{1}\" causality=\"input\" start=\"0\"/>\n",
                        type, reference);
    text += fmt::format("<{0} name=\"{0}_output\" valueReference=\"{1}\" causality=\"output\"/>\n", type,
                        reference + 11);
  }
  return text;
}

std::string text_of(const std::map<std::string, std::string>& texts, const std::string& kind) {
  const auto found = texts.find(kind);
  return found == texts.end() ? "" : found->second;
}

}  // namespace

std::string write_zip(const std::string& path, const Entries& entries) {
  int reason = 0;
  zip_t* zip = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &reason);
  if (!zip) throw std::runtime_error("no archive " + path);
  for (const auto& [name, content] : entries)
    zip_file_add(zip, name.c_str(), zip_source_buffer(zip, content.data(), content.size(), 0), 0);
  if (zip_close(zip) != 0) throw std::runtime_error("cannot write " + path);
  return path;
}

Entries unit_of_3(const std::string& kind) {
  const std::string listed = kind == "feedthrough" ? feedthrough_variables() : text_of(variables, kind);
  const std::string interface =
      R"xml(modelIdentifier="unit" canGetAndSetFMUState="true" canSerializeFMUState="true"/>)xml";
  const std::string description = fmt::format(
      R"xml(<?xml version="1.0"?>
<fmiModelDescription fmiVersion="3.0" modelName="{0}" instantiationToken="{0}">
<ModelExchange {1}<CoSimulation {1}
<UnitDefinitions>
<Unit name="m"><BaseUnit m="1"/></Unit><Unit name="mm"><BaseUnit m="1" factor="0.001"/></Unit>
<Unit name="m/s"><BaseUnit m="1" s="-1"/></Unit><Unit name="1/s"><BaseUnit s="-1"/></Unit>
</UnitDefinitions>
<ModelVariables><Float64 name="time" valueReference="0" causality="independent"/>
{2}</ModelVariables>
<ModelStructure>{3}</ModelStructure>
</fmiModelDescription>)xml",
      kind, interface, listed, text_of(structure, kind));
  return {{"modelDescription.xml", description},
          {"binaries/x86_64-linux/unit.so", bytes_of(UNIT_OF_3)},
          {"binaries/aarch64-linux/unit.so", bytes_of(UNIT_OF_3)}};
}

Entries bad_unit(int version, const std::string& deed) {
  const std::string about = fmt::format("fmiVersion=\"{}.0\" modelName=\"bad\" {}=\"{}\"", version,
                                        version == 3 ? "instantiationToken" : "guid", deed);
  const std::string variables =
      version == 3
          ? R"xml(<Float64 name="y" valueReference="1" causality="output"/><Float64 name="z" valueReference="2"/>)xml"
          : R"xml(<ScalarVariable name="y" valueReference="1" causality="output"><Real/></ScalarVariable>)xml";
  const std::string description = fmt::format(
      R"xml(<fmiModelDescription {}{}><ModelExchange modelIdentifier="unit"/><CoSimulation modelIdentifier="unit"{}/>
<ModelVariables>{}</ModelVariables><ModelStructure>{}</ModelStructure></fmiModelDescription>)xml",
      about, version == 3 ? "" : " numberOfEventIndicators=\"1\"",
      version == 3 ? " fixedInternalStepSize=\"5e-3\"" : "", variables,
      version == 3 ? "<EventIndicator valueReference=\"2\"/>" : "");
  Entries entries{{"modelDescription.xml", description}};
  for (const char* platform : {"x86_64-linux", "aarch64-linux", "linux64"})
    entries[fmt::format("binaries/{}/unit.so", platform)] = bytes_of(BAD_UNIT);
  return entries;
}

}  // namespace stepwire::testing
