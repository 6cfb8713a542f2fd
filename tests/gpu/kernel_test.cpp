#include "engine/simulate/device/kernel_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <mutex>
#include <set>

#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/model/plan/variable_blocks.hpp"
#include "engine/simulate/codegen/library.hpp"
#include "engine/simulate/device/ptx_compiler.hpp"
#include "engine/simulate/device/run_group.hpp"
#include "tests/diagrams/diagram_files.hpp"
#include "tests/diagrams/varied_runs.hpp"
#include "tests/gpu/host_device.hpp"

namespace stepwire::device {

namespace {

constexpr std::size_t runs_of_a_group = 3;

/// Diagram with values that differ between its runs, and the text of its kernel.
struct Compared {
  plan::Plan plan;
  std::vector<Varied> varied;
  std::vector<plan::VariableBlock> variable;
  KernelText kernel;
  std::string refused;  ///< reason why it does not go
};

Compared compared_of(const run::Job& job) {
  Compared one{short_plan(job), {}, {}, {}, why_not_on_device(job.plan)};
  if (!one.refused.empty()) return one;
  one.varied = varied_of(one.plan);
  one.variable = plan::variable_blocks(one.plan, variation_of(one.plan, one.varied));
  for (std::size_t run = 1; run < runs_of_a_group; ++run)
    run_of(one.plan, one.varied, run)->widen(one.variable);
  try {
    one.kernel = make_kernel(one.plan, one.variable);
  } catch (const yaml::Error& error) {
    one.refused = error.faults().front().message.text();
  }
  return one;
}

std::vector<std::unique_ptr<Compared>> compared_of(const std::vector<run::Job>& jobs) {
  std::vector<std::unique_ptr<Compared>> all(jobs.size());
  in_parallel(jobs.size(), [&](std::size_t i) { all[i] = std::make_unique<Compared>(compared_of(jobs[i])); });
  return all;
}

/// Run of a group, with its recording.
struct Grouped {
  std::unique_ptr<run::Executor> run;
  record::RunRecording recording;
};

/// Returns the first difference between runs of a group and runs alone; an empty text without one.
std::string difference_of(const Compared& one, Device& device, Kernel& kernel) {
  std::vector<std::unique_ptr<Grouped>> runs;
  std::vector<RunGroup::Run> group;
  for (std::size_t i = 0; i < runs_of_a_group; ++i) {
    runs.push_back(
        std::make_unique<Grouped>(Grouped{run_of(one.plan, one.varied, i), record::RunRecording(one.plan)}));
    group.push_back({runs.back()->run.get(), &runs.back()->recording.recorders()});
  }
  RunGroup together(device, kernel, one.variable, group);
  if (!together.fits()) return "its runs differ in what is the same for all";
  while (together.goes_on()) together.step();
  together.finish();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto alone = run_of(one.plan, one.varied, i);
    record::RunRecording own(one.plan);
    go_alone(*alone, own.recorders());
    if (!same_bits(own.take(), runs[i]->recording.take())) return fmt::format("run {}", i);
    if (alone->tick() != runs[i]->run->tick() || alone->healthy() != runs[i]->run->healthy())
      return fmt::format("the end of run {}", i);
  }
  return "";
}

/// Compiles the kernels for the processor and compares their runs. Returns the count of the compared ones.
std::size_t compare_all(const std::vector<std::unique_ptr<Compared>>& all) {
  const subprocess::ScratchFolder folder;
  std::vector<std::string> differences(all.size());
  std::size_t count = 0;
  in_parallel(all.size(), [&](std::size_t i) {
    if (!all[i]->refused.empty()) return;
    std::string problem;
    HostDevice host;
    const std::string library =
        host_library(all[i]->kernel, folder.path() + "/" + std::to_string(i), problem);
    differences[i] = library.empty() ? problem : difference_of(*all[i], host, *host.load(library));
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO(all[i]->plan.diagram.file);
    CHECK(differences[i] == "");
    count += all[i]->refused.empty() ? 1 : 0;
  }
  return count;
}

/// Returns the first instruction of PTX whose rounding may differ from that of the processor; an empty text
/// without one.
std::string loose_rounding(const std::string& ptx) {
  for (const char* instruction : {"fma.rn.f64", "add.f64", "sub.f64", "mul.f64", ".approx", "div.full"})
    if (ptx.find(instruction) != std::string::npos) return instruction;
  return "";
}

/// Compiles the kernels to PTX. Sets the reasons of those that no device can run, and returns the
/// instructions with another rounding.
std::set<std::string> compile_to_ptx(std::vector<std::unique_ptr<Compared>>& all,
                                     const PtxCompiler& compiler) {
  std::mutex mutex;
  std::set<std::string> loose;
  in_parallel(all.size(), [&](std::size_t i) {
    if (!all[i]->refused.empty()) return;
    std::string why;
    const std::string ptx = compiler.compile(all[i]->kernel, {}, why);
    if (ptx.empty()) all[i]->refused = why;
    const std::lock_guard lock(mutex);
    if (const std::string found = loose_rounding(ptx); !found.empty()) loose.insert(found);
  });
  return loose;
}

bool goes(const run::Job& job) {
  return why_not_on_device(job.plan).empty();
}

/// Returns the count of each reason, a line each.
std::string reasons_of(const std::vector<std::unique_ptr<Compared>>& all) {
  std::map<std::string, std::vector<std::string>> files;
  for (const auto& one : all)
    if (!one->refused.empty()) files[one->refused].push_back(one->plan.diagram.file);
  std::string text;
  for (const auto& [reason, of] : files)
    text += fmt::format("{} diagrams, such as {}: {}\n", of.size(), of.front(), reason);
  return text;
}

std::vector<run::Job> first_of(std::vector<run::Job> jobs, std::size_t count) {
  jobs.erase(jobs.begin() + static_cast<std::ptrdiff_t>(std::min(count, jobs.size())), jobs.end());
  return jobs;
}

}  // namespace

TEST_CASE("kernels on the processor give the bits of runs alone in some diagrams") {
  CHECK(compare_all(compared_of(first_of(jobs_of_all_blocks(goes), 6))) == 6);
}

TEST_CASE("kernels on the processor give the bits of runs alone in diagrams of all blocks", "[long]") {
  CHECK(compare_all(compared_of(jobs_of_all_blocks(goes))) > 40);
}

TEST_CASE("a kernel becomes PTX without open calls and with the rounding of the processor") {
  const PtxCompiler compiler{io::Cache("", 0)};
  if (!compiler.found()) {
    WARN(compiler.problem());
    return;
  }
  auto all = compared_of(first_of(jobs_of_all_blocks(goes), 2));
  CHECK(compile_to_ptx(all, compiler).empty());
  for (const auto& one : all) CHECK(one->refused == "");
}

TEST_CASE("open calls of PTX are found") {
  CHECK(unresolved_call(".extern .func (.param .b32 r) _Z3sind\n(") == "sin(double)");
  CHECK(unresolved_call(".extern .func malloc\n(") == "malloc");
  CHECK(unresolved_call(".func stepwire(") == "");
}

TEST_CASE("kernels of all diagrams become PTX, and give the bits of runs alone", "[long]") {
  const PtxCompiler compiler{io::Cache("", 0)};
  if (!compiler.found()) {
    WARN(compiler.problem());
    return;
  }
  auto all = compared_of(distinct_jobs());
  CHECK(compile_to_ptx(all, compiler).empty());
  const auto count = std::ranges::count_if(all, [](const auto& one) { return one->refused.empty(); });
  WARN(count << " of " << all.size() << " diagrams go to a device\n" << reasons_of(all));
  CHECK(2 * static_cast<std::size_t>(count) > all.size());
  CHECK(compare_all(all) == static_cast<std::size_t>(count));
}

}  // namespace stepwire::device
