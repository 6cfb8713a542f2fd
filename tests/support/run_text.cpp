#include "tests/support/run_text.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "blocks/register.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire {

namespace {

std::string with_head(const std::string& yaml) {
  std::string head;
  if (yaml.find("stepwire:") == std::string::npos) head += "stepwire: 1\n";
  if (yaml.find("title:") == std::string::npos) head += "title: a test\n";
  return head + yaml;
}

run::RunResult run_of(const std::string& yaml) {
  static const Registry registry = blocks();
  diagram::Loader loader(registry);
  const std::string beside = (std::filesystem::path(STEPWIRE_SOURCE_DIR) / "tests" / "test.yaml").string();
  const plan::Plan plan = plan::make_plan(loader.load_text(with_head(yaml), beside));
  return run::run_plan(plan);
}

}  // namespace

table::Table run_text(const std::string& yaml) {
  run::RunResult result = run_of(yaml);
  for (const run::RunFault& fault : result.faults) FAIL(fault.fault.text());
  REQUIRE(!result.recordings.empty());
  return std::move(result.recordings.front().table);
}

const std::vector<double>& column(const table::Table& table, const std::string& name) {
  const table::Column* found = table.find(name);
  INFO("column " << name);
  REQUIRE(found != nullptr);
  return found->values;
}

std::string error_of(const std::string& yaml) {
  try {
    const run::RunResult result = run_of(yaml);
    return result.faults.empty() ? "" : result.faults.front().fault.text();
  } catch (const yaml::Error& error) {
    return error.what();
  }
}

}  // namespace stepwire
