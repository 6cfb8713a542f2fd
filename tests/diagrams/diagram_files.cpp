#include "tests/diagrams/diagram_files.hpp"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <set>
#include <thread>

#include "blocks/register.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/simulate/codegen/generated_code.hpp"

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

/// The code of a job; its file's name where it cannot be generated.
std::string code_of(const run::Job& job) try {
  return codegen::library_source(codegen::make_program(job.plan));
} catch (const yaml::Error&) {
  return job.plan.diagram.file;
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

std::vector<run::Job> distinct_jobs() {
  std::vector<run::Job> jobs;
  std::set<std::pair<std::string, std::size_t>> known;
  for_every_job([&](run::Job job) {
    if (known.emplace(code_of(job), job.points.size()).second) jobs.push_back(std::move(job));
  });
  return jobs;
}

std::vector<run::Job> jobs_of_all_blocks(const std::function<bool(const run::Job&)>& fits) {
  std::vector<run::Job> jobs;
  std::set<std::string> known;
  for_every_job([&](run::Job job) {
    if (!fits(job)) return;
    bool is_new = false;
    for (const diagram::DiagramBlock& block : job.plan.diagram.blocks)
      is_new = known.insert(block.type().name).second || is_new;
    if (is_new) jobs.push_back(std::move(job));
  });
  return jobs;
}

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back([&] {
      for (std::size_t at = next++; at < count; at = next++) work(at);
    });
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
