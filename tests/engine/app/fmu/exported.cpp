#include "tests/engine/app/fmu/exported.hpp"

#include <dlfcn.h>

#include <catch2/catch.hpp>

#include "blocks/register.hpp"
#include "engine/app/fmu/unit_export.hpp"
#include "engine/base/archive/archive.hpp"
#include "engine/base/fmi/package.hpp"
#include "engine/base/io/file.hpp"
#include "engine/model/diagram/load.hpp"
#include "tests/support/units/schema.hpp"

namespace stepwire::fmu {

namespace {

const codegen::Compiler& compiler() {
  static const codegen::Compiler one;
  return one;
}

}  // namespace

bool there_is_a_compiler() {
  if (compiler().found()) return true;
  WARN("there is no C++ compiler here; nothing was exported");
  return false;
}

std::map<std::string, std::string> unit_files(const Scratch& folder, const std::string& name,
                                              const std::string& yaml, int version) {
  static const Registry registry = blocks();
  const std::string path = folder.file(name + ".yaml", yaml);
  const plan::Plan plan = plan::make_plan(diagram::Loader(registry).load(path));
  auto unit =
      export_unit(plan, codegen::tuning_of(plan),
                  {.version = version, .name = name, .made_by = "a test", .flags = {"-O0"}}, compiler());
  const std::string description = folder.file(name + ".xml", unit.files.at("modelDescription.xml"));
  CHECK(testing::schema_fault(description, version) == "");
  return unit.files;
}

std::string exported(const Scratch& folder, const std::string& name, const std::string& yaml, int version) {
  const std::string path = folder.path(name + ".fmu");
  io::write_file(path, archive::archive_bytes(unit_files(folder, name, yaml, version)));
  return path;
}

Binary::Binary(const std::string& name, const std::string& yaml, int version) {
  const Scratch folder;
  auto files = unit_files(folder, name, yaml, version);
  const std::string& description = files.at("modelDescription.xml");
  const std::string key = version == 2 ? "guid=\"" : "instantiationToken=\"";
  const std::size_t at = description.find(key) + key.size();
  token_ = description.substr(at, description.find('"', at) - at);
  const std::string path = folder.path(name + ".so");
  io::write_file(path, files.at(fmi::binary_folder(version) + name + ".so"));
  library_ = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  REQUIRE(library_);
}

void* Binary::address(const char* name) const {
  void* found = dlsym(library_, name);
  INFO(name);
  REQUIRE(found);
  return found;
}

}  // namespace stepwire::fmu
