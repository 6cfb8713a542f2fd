#include "tests/blocks/contract_library.hpp"

#include <dlfcn.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "engine/base/subprocess/process.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/library.hpp"

namespace stepwire {

namespace {

/// The names in a table of dynamic symbols, by nm of binutils, which comes with the compiler.
std::vector<std::string> symbols_of(const std::string& library, const std::string& which) {
  const subprocess::ProcessResult result =
      subprocess::run_process({.command = {"nm", "-D", "-C", "--format=just-symbols", which, library}});
  CHECK(result.succeeded());
  std::istringstream lines(result.output);
  std::vector<std::string> names;
  for (std::string name; std::getline(lines, name);) names.push_back(name);
  return names;
}

}  // namespace

ContractLibrary::ContractLibrary(const std::string& source, const std::string& optimisation) {
  ::setenv("STEPWIRE_HELPER_LIMIT", "1200", 0);  // one source of all blocks, compiled beside other tests
  const codegen::Compiler compiler;
  const subprocess::ScratchFolder folder;
  const std::string stem = folder.path() + "/all", library = stem + ".so";
  std::ofstream(stem + ".cpp") << source;
  std::vector<std::string> flags = codegen::library_flags();
  flags.push_back(optimisation);
  flags.push_back("-DSTEPWIRE_SLEEF");
  const std::string problem = compiler.compile(stem + ".cpp", library, flags, {});
  INFO(problem.substr(0, 2000));
  REQUIRE(problem.empty());
  undefined_ = symbols_of(library, "--undefined-only");
  exported_ = symbols_of(library, "--defined-only");
  library_ = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  REQUIRE(library_);
}

ContractLibrary::~ContractLibrary() {
  ::dlclose(library_);
}

void* ContractLibrary::address(const std::string& name) const {
  return ::dlsym(library_, name.c_str());
}

bool has_compiler() {
  const bool found = codegen::Compiler().found();
  if (!found) WARN("there is no C++ compiler here; nothing was compared");
  return found;
}

}  // namespace stepwire
