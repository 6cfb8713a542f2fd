#include "tests/support/plan_text.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "blocks/register.hpp"

namespace stepwire {

namespace {

std::string with_tail(std::string yaml) {
  if (!yaml.ends_with('\n')) yaml += '\n';
  for (const auto& [key, line] :
       std::vector<std::pair<std::string, std::string>>{{"stepwire:", "stepwire: 1\n"},
                                                        {"title:", "title: a test\n"},
                                                        {"\nstep:", "step: 1 s\n"},
                                                        {"\nstop:", "stop: 3 s\n"}})
    if (("\n" + yaml).find(key) == std::string::npos) yaml += line;
  return yaml;
}

template <class Make>
std::vector<std::string> faults_in(const Make& make) {
  std::vector<std::string> lines;
  try {
    const plan::Plan plan = make();
    const run::Executor simulation(plan);
  } catch (const yaml::Error& error) {
    for (const yaml::Fault& fault : error.faults()) lines.push_back(fault.text());
  }
  return lines;
}

}  // namespace

const Registry& library() {
  static const Registry registry = blocks();
  return registry;
}

plan::Plan plan_text(const std::string& yaml, const std::vector<diagram::Setting>& settings,
                     const Registry& registry) {
  diagram::Loader loader(registry);
  return plan::make_plan(loader.load_text(with_tail(yaml), "test.yaml", settings));
}

run::RunResult result_of(const std::string& yaml, const std::vector<diagram::Setting>& settings,
                         const Registry& registry) {
  const plan::Plan plan = plan_text(yaml, settings, registry);
  return run::run_plan(plan);
}

std::vector<std::string> faults_of(const std::string& yaml, const std::vector<diagram::Setting>& settings,
                                   const Registry& registry) {
  return faults_in([&] { return plan_text(yaml, settings, registry); });
}

DiagramFolder::DiagramFolder() {
  static int count = 0;
  folder_ = std::filesystem::temp_directory_path() /
            ("stepwire_" + std::to_string(getpid()) + "_" + std::to_string(count++));
  std::filesystem::create_directories(folder_);
}

DiagramFolder::~DiagramFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void DiagramFolder::write(const std::string& name, const std::string& yaml) const {
  std::filesystem::create_directories((folder_ / name).parent_path());
  std::ofstream(folder_ / name) << yaml;
}

plan::Plan DiagramFolder::plan(const std::string& name, const std::vector<diagram::Setting>& settings) const {
  diagram::Loader loader(library());
  return plan::make_plan(loader.load(path(name), settings));
}

table::Table DiagramFolder::run(const std::string& name,
                                const std::vector<diagram::Setting>& settings) const {
  const plan::Plan planned = plan(name, settings);
  run::RunResult result = run::run_plan(planned);
  for (const run::RunFault& fault : result.faults) FAIL(fault.fault.text());
  REQUIRE(!result.recordings.empty());
  return std::move(result.recordings.front().table);
}

std::vector<std::string> DiagramFolder::faults(const std::string& name,
                                               const std::vector<diagram::Setting>& settings) const {
  std::vector<std::string> lines = faults_in([&] { return plan(name, settings); });
  const std::string folder = folder_.string() + "/";
  for (std::string& line : lines)
    for (auto at = line.find(folder); at != std::string::npos; at = line.find(folder))
      line.erase(at, folder.size());
  return lines;
}

}  // namespace stepwire
