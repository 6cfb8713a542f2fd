#include "tests/support/units/schema.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "engine/base/subprocess/process.hpp"

namespace stepwire::testing {

std::string schema_fault(const std::string& path, int version, const std::string& schema) {
  const char* data = std::getenv("STEPWIRE_DATA");
  const std::string kind = "fmi" + std::to_string(version);
  const std::filesystem::path file =
      std::filesystem::path(data ? data : "") / "fmi" / kind / (kind + schema + ".xsd");
  if (!data || !std::filesystem::exists(file) || subprocess::find_program("xmllint").empty()) return "";
  const subprocess::ProcessResult result =
      subprocess::run_process({.command = {"xmllint", "--noout", "--schema", file.string(), path}});
  return result.succeeded() ? "" : "not valid: " + result.errors;
}

}  // namespace stepwire::testing
