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

using namespace stepwire;

namespace {

constexpr std::int64_t ticks = 500;
constexpr std::size_t most_varied = 4;

/// Values of a diagram's blocks that may have other numbers: "spring.gain", and its number.
struct Varied {
  std::string name;
  double value;
  std::string unit;
};

/// As `--set` has it, a bit more in each lane.
std::string text_of(const Varied& varied, std::size_t lane) {
  return fmt::format("{} {}", varied.value * (1.0 + 1e-3 * static_cast<double>(lane)), varied.unit);
}

/// True if a run with this value keeps the plan and its numbers are finite for three ticks.
bool may_vary(const plan::Plan& plan, const Varied& varied) try {
  run::Executor run(plan);
  if (run.set(varied.name, text_of(varied, 7)) != run::Executor::Setting::done) return false;
  run.reset();
  for (int tick = 0; tick < 3 && run.healthy(); ++tick) {
    run.evaluate();
    run.advance();
  }
  return run.healthy();
} catch (const std::exception&) {
  return false;
}

std::string si_unit_of(const ParameterSpec& spec) {
  const auto unit = unit::parse_unit(spec.unit);
  return unit ? unit::si_name(unit->dimension) : "";
}

/// Parameters of blocks that are single numbers, spread over the diagram.
std::vector<Varied> varied_of(const plan::Plan& plan) {
  std::vector<Varied> all;
  for (const diagram::DiagramBlock& block : plan.diagram.blocks)
    for (const ParameterSpec& spec : block.type().parameters) {
      const Value value = spec.get ? spec.get(block.block.get()) : Value{};
      const double* number = std::get_if<double>(&value.content);
      if (number && *number != 0.0 && std::isfinite(*number))
        all.push_back({block.name + "." + spec.name, *number, si_unit_of(spec)});
    }
  std::vector<Varied> chosen;
  const std::size_t stride = std::max<std::size_t>(1, all.size() / (3 * most_varied));
  for (std::size_t i = 0; i < all.size() && chosen.size() < most_varied; i += stride)
    if (may_vary(plan, all[i])) chosen.push_back(all[i]);
  return chosen;
}

diagram::Variation variation_of(const plan::Plan& plan, const std::vector<Varied>& varied) {
  std::vector<std::string> names;
  for (const Varied& one : varied) names.push_back(one.name);
  return diagram::Variation(plan.diagram, names);
}

/// A run at time 0 with the values of a lane.
std::unique_ptr<run::Executor> run_of(const plan::Plan& plan, const std::vector<Varied>& varied,
                                      std::size_t lane) {
  auto run = std::make_unique<run::Executor>(plan);
  for (const Varied& one : varied) static_cast<void>(run->set(one.name, text_of(one, lane)));
  run->reset();
  return run;
}

/// Records each tick of a run by itself, interpreted, as Drive does.
void go_alone(run::Executor& run, std::vector<record::Recorder>& recorders) {
  const run::StopConditionEvaluator stopper(run.plan());
  while (true) {
    run.evaluate();
    if (!run.healthy()) return;
    const bool last = run.finished() || stopper.stops(run.values());
    for (record::Recorder& recorder : recorders) recorder.record(run.tick(), run.values(), last);
    if (last) return;
    run.advance();
    if (!run.healthy()) return;
  }
}

bool same_bits(const std::vector<record::Recording>& a, const std::vector<record::Recording>& b) {
  for (std::size_t r = 0; r < a.size(); ++r)
    for (std::size_t c = 0; c < a[r].table.columns.size(); ++c) {
      const auto &one = a[r].table.columns[c].values, &other = b[r].table.columns[c].values;
      if (one.size() != other.size() ||
          std::memcmp(one.data(), other.data(), one.size() * sizeof(double)) != 0)
        return false;
    }
  return true;
}

/// A plan of a few ticks that records each of them.
plan::Plan short_plan(const run::Job& job) {
  plan::Plan plan = job.plan;
  plan.steps = std::min(plan.steps, ticks);
  for (diagram::RecordRequest& request : plan.diagram.records)
    if (request.every && *request.every > 8.0 * plan.diagram.step) request.every.reset();
  return plan;
}

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
    if (!same_bits(own.take(), recordings[l]->take())) return fmt::format("lane {}", l);
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
