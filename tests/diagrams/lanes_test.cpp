#include <fmt/format.h>
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cstring>
#include <functional>
#include <set>
#include <thread>

#include "engine/model/plan/variable_blocks.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/codegen/lane_places.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/lane_group.hpp"
#include "tests/diagrams/diagram_files.hpp"
#include "tests/diagrams/varied_runs.hpp"

using namespace stepwire;

namespace {

std::string difference_of(const plan::Plan& plan, const std::vector<Varied>& varied,
                          const plan::CompiledLanes& code) {
  std::vector<std::unique_ptr<run::Executor>> runs;
  std::vector<std::unique_ptr<record::RunRecording>> recordings;
  std::vector<run::LaneGroup::Run> lanes;
  for (int l = 0; l + 1 < code.lanes; ++l) {  // one lane is a copy
    runs.push_back(run_of(plan, varied, static_cast<std::size_t>(l)));
    recordings.push_back(std::make_unique<record::RunRecording>(plan));
    lanes.push_back({runs.back().get(), &recordings.back()->recorders()});
  }
  run::LaneGroup group(code, lanes);
  if (!group.fits()) return "its runs differ in what is the same for all";
  while (group.goes_on()) group.step(run::LaneGroup::ticks_at_once);
  for (std::size_t l = 0; l < runs.size(); ++l) {
    const auto alone = run_of(plan, varied, l);
    record::RunRecording own(plan);
    go_alone(*alone, own.recorders());
    if (!stepwire::same_bits(own.take(), recordings[l]->take())) return fmt::format("lane {}", l);
    if (alone->tick() != runs[l]->tick() || alone->healthy() != runs[l]->healthy())
      return fmt::format("the end of lane {}", l);
  }
  return "";
}

/// A diagram with values that differ between its runs, and its code in lanes.
struct Compared {
  plan::Plan plan;
  std::vector<Varied> varied;
  plan::RunDifferences differences;
  std::optional<plan::CompiledLanes> code;
  std::string refused;
};

Compared compared_of(const run::Job& job) {
  Compared one{short_plan(job), {}, {}, {}, ""};
  one.varied = varied_of(one.plan);
  const diagram::Variation variation = variation_of(one.plan, one.varied);
  one.differences = {plan::variable_blocks(one.plan, variation), variation.targets()};
  for (const std::size_t lane : {1, 7}) run_of(one.plan, one.varied, lane)->widen(one.differences.variable);
  return one;
}

void compile_all(std::vector<std::unique_ptr<Compared>>& all) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back([&] {
      codegen::GeneratedCode source{run::code_trial()};
      for (std::size_t at = next++; at < all.size(); at = next++)
        all[at]->code = source.compile_lanes(all[at]->plan, all[at]->differences, {}, all[at]->refused);
    });
}

bool goes_in_lanes(const run::Job& job) {
  return codegen::why_not_in_lanes(job.plan).empty();
}

void compare_all(const std::vector<run::Job>& jobs) {
  std::vector<std::unique_ptr<Compared>> all;
  for (const run::Job& job : jobs) all.push_back(std::make_unique<Compared>(compared_of(job)));
  compile_all(all);
  std::size_t in_lanes = 0;
  for (const auto& one : all) {
    INFO(one->plan.diagram.file);
    if (one->code)
      CHECK(difference_of(one->plan, one->varied, *one->code) == "");
    else
      WARN(one->plan.diagram.file << " has no lanes: " << one->refused);
    in_lanes += one->code ? 1 : 0;
  }
  CHECK(in_lanes == all.size());
}

bool has_lanes() {
  const codegen::Compiler compiler;
  const bool wide = __builtin_cpu_supports("avx2");
  if (!compiler.found() || !compiler.is_gcc() || !wide) WARN("there are no lanes here; nothing was compared");
  return compiler.found() && compiler.is_gcc() && wide;
}

}  // namespace

TEST_CASE("runs in lanes give the bits of runs alone in diagrams of all blocks") {
  if (has_lanes()) compare_all(jobs_of_all_blocks(goes_in_lanes));
}

TEST_CASE("runs in lanes give the bits of runs alone in every diagram", "[long]") {
  if (!has_lanes()) return;
  std::vector<run::Job> jobs;
  for_every_job([&](run::Job job) {
    if (goes_in_lanes(job)) jobs.push_back(std::move(job));
  });
  compare_all(jobs);
}
