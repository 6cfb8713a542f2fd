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

RunResult run(const std::string& yaml) {
  static const Registry registry = blocks();
  Loader loader(registry);
  const std::string beside = (std::filesystem::path(STEPWIRE_SOURCE_DIR) / "tests" / "test.yaml").string();
  const Plan plan = make_plan(loader.load_text(with_head(yaml), beside));
  return run_plan(plan);
}

}  // namespace

Table run_text(const std::string& yaml) {
  RunResult result = run(yaml);
  for (const RunFault& fault : result.faults) FAIL(fault.fault.text());
  REQUIRE(!result.recordings.empty());
  return std::move(result.recordings.front().table);
}

const std::vector<double>& column(const Table& table, const std::string& name) {
  const Column* found = table.find(name);
  INFO("column " << name);
  REQUIRE(found != nullptr);
  return found->values;
}

std::string error_of(const std::string& yaml) {
  try {
    const RunResult result = run(yaml);
    return result.faults.empty() ? "" : result.faults.front().fault.text();
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace stepwire
