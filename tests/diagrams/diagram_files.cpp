#include "tests/diagrams/diagram_files.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>

#include "blocks/register.hpp"
#include "engine/base/io/environment_error.hpp"

namespace stepwire {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_to_run() {
  std::vector<std::string> files;
  for (const char* folder : {"examples", "thesis"})
    for (const auto& entry : fs::directory_iterator(fs::path(STEPWIRE_SOURCE_DIR) / "diagrams" / folder))
      if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

plan::Plan plan_at(const run::Job& job, std::size_t point) {
  static const Registry registry = blocks();
  return plan::make_plan(diagram::Loader(registry).load_point(job.plan.diagram.file, job.settings_of(point)));
}

void for_every_diagram(const std::function<void(const plan::Plan& plan)>& check) {
  for_every_job([&](const run::Job& job) {
    check(job.plan);
    if (job.points.empty()) return;
    check(plan_at(job, 0));
    check(plan_at(job, job.points.size() - 1));
  });
}

void for_every_job(const std::function<void(run::Job job)>& check) {
  static const Registry registry = blocks();
  for (const std::string& file : files_to_run()) {
    INFO(file);
    try {
      diagram::Loader loader(registry);
      check(run::make_job(loader, file));
    } catch (const io::EnvironmentError& error) {
      WARN("skipped: " << error.what());
    }
  }
}

std::uint64_t fingerprint(run::Executor& simulation, std::int64_t last) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a over all numbers of all ticks
  while (simulation.healthy() && simulation.tick() < last) {
    simulation.evaluate();
    for (double number : simulation.workspace().values) {
      std::uint64_t bits;
      std::memcpy(&bits, &number, sizeof bits);
      hash = (hash ^ bits) * 0x100000001b3;
    }
    simulation.advance();
  }
  return hash;
}

}  // namespace stepwire
