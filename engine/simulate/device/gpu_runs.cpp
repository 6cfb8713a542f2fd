#include "engine/simulate/device/gpu_runs.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "engine/simulate/device/cuda.hpp"
#include "engine/simulate/device/run_group.hpp"

namespace stepwire::device {

namespace {

constexpr std::size_t fewest = 32;         // Runs of a plan that are worth a compilation: those of a warp.
constexpr std::size_t most_runs = 8192;    // Runs of a group.
constexpr double host_memory = 1e9;        // Memory of all groups together [bytes].
constexpr double bytes_of_calls = 2048.0;  // Memory of a block in the tables of an executor.
constexpr double part_of_device = 0.5;     // Part of its free memory, for all groups together.

/// Returns the bytes of a run in the memory of this process: its executor, its numbers and their copies, and
/// its rows.
double memory_here(const plan::Plan& plan, bool keeps_rows) {
  double numbers = 4.0 * static_cast<double>(plan.layout.size), blocks = 0.0;
  for (const diagram::RecordRequest& request : plan.diagram.records)
    if (keeps_rows)
      numbers += static_cast<double>(record::max_rows(plan, request) *
                                     record::recorded_columns(plan, request).size());
  for (const diagram::DiagramBlock& block : plan.diagram.blocks)
    blocks += static_cast<double>(block.type().bytes) + bytes_of_calls;
  return sizeof(double) * numbers + blocks;
}

/// Runs of one call.
class Runs : public run::DeviceRuns {
 public:
  Runs(const std::vector<run::PlanOfRuns>& members, const run::DeviceCall& call)
      : members_(members.size()), call_(call) {}

  void refuse(const std::string& why) {
    const std::lock_guard lock(mutex_);
    if (report_.why_not.empty()) report_.why_not = why;
  }

  /// Compiles and loads the kernels of all plans with enough runs.
  void prepare(const std::vector<run::PlanOfRuns>& plans, const PtxCompiler& compiler,
               std::shared_ptr<Device> device) {
    device_ = std::move(device);
    for (std::size_t m = 0; m < plans.size(); ++m)
      if (std::string why = prepare(plans[m], compiler, members_[m]); !why.empty()) refuse(why);
  }

  std::size_t at_once(std::size_t member) const override {
    return member < members_.size() ? members_[member].at_once.load() : 0;
  }

  bool run(std::size_t member, std::vector<run::PendingRun>& runs) override {
    Member& of = members_[member];
    try {
      if (step(of, runs)) return true;
      refuse("its runs differ in numbers that the kernel has for all");
    } catch (const DeviceError& error) {
      refuse(error.what());
    }
    of.at_once = 0;
    for (run::PendingRun& run : runs) {
      run.simulation->reset();
      for (record::Recorder& recorder : *run.recorders) recorder.go_back_to(0);
    }
    return false;
  }

  run::DeviceReport report() const override {
    const std::lock_guard lock(mutex_);
    return report_;
  }

 private:
  struct Member {
    std::unique_ptr<Kernel> kernel;
    std::vector<plan::VariableBlock> variable;
    std::atomic<std::size_t> at_once = 0;
  };

  /// Returns the reason why the runs of a plan do not go to the device; an empty text if they do.
  std::string prepare(const run::PlanOfRuns& plan, const PtxCompiler& compiler, Member& member) {
    if (plan.runs.value_or(0) < fewest) return "fewer than 32 runs have the same structure";
    try {
      std::string why = why_not_on_device(*plan.plan);
      if (!why.empty()) return why;
      const std::string ptx = compiler.compile(make_kernel(*plan.plan, plan.differences.variable), {}, why);
      if (ptx.empty()) return why;
      member.kernel = device_->load(ptx);
      member.variable = plan.differences.variable;
      member.at_once = size_of_group(plan);
      return "";
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  /// Returns the number of runs that have room here and on the device, and give each thread its part.
  std::size_t size_of_group(const run::PlanOfRuns& plan) const {
    const double threads = call_.threads;
    const double there = part_of_device * static_cast<double>(device_->free_memory()) / threads;
    const double of_run = static_cast<double>(memory_of_run(*plan.plan, 0));
    const double here = host_memory / threads / memory_here(*plan.plan, call_.keeps_rows);
    const double part =
        std::max(static_cast<double>(fewest), static_cast<double>(*plan.runs) / threads + 1.0);
    return static_cast<std::size_t>(
        std::clamp(std::min({part, here, 0.5 * there / of_run}), 1.0, static_cast<double>(most_runs)));
  }

  bool step(Member& member, std::vector<run::PendingRun>& runs) {
    std::vector<RunGroup::Run> own;
    for (run::PendingRun& run : runs) own.push_back({run.simulation, run.recorders});
    RunGroup group(*device_, *member.kernel, member.variable, std::move(own));
    if (!group.fits()) return false;
    while (group.goes_on() && !(call_.interrupt && *call_.interrupt)) group.step();
    const std::vector<bool> active = group.finish();
    for (std::size_t i = 0; i < runs.size(); ++i) {
      runs[i].end = run::end_of(*runs[i].simulation);
      runs[i].end.interrupted = active[i];
      runs[i].end.compiled_ticks = runs[i].end.ticks;
    }
    const std::lock_guard lock(mutex_);
    report_.name = device_->name();
    report_.runs += runs.size();
    return true;
  }

  std::shared_ptr<Device> device_;  ///< outlives the kernels
  std::vector<Member> members_;
  const run::DeviceCall call_;
  mutable std::mutex mutex_;
  run::DeviceReport report_;
};

/// True for a sweep that is large enough for the device.
bool is_large(const std::vector<run::PlanOfRuns>& members) {
  double runs = 0.0, ticks = 0.0;
  for (const run::PlanOfRuns& member : members) {
    const auto of_member = static_cast<double>(member.runs.value_or(0));
    runs += of_member;
    ticks += of_member * static_cast<double>(member.plan->steps);
  }
  return runs >= least_runs && ticks >= least_ticks;
}

}  // namespace

GpuRuns::GpuRuns(DeviceUse use) : GpuRuns(use, open_cuda) {}

bool GpuRuns::find(std::string& why) {
  if (!compiler_) compiler_ = std::make_unique<PtxCompiler>();
  why = compiler_->found() ? "" : compiler_->problem();
  if (why.empty() && !device_) device_ = opener_(why);
  return device_ != nullptr && compiler_->found();
}

std::unique_ptr<run::DeviceRuns> GpuRuns::open(const std::vector<run::PlanOfRuns>& members,
                                               const run::DeviceCall& call) {
  auto runs = std::make_unique<Runs>(members, call);
  const std::lock_guard lock(mutex_);
  std::string why;
  if (use_ == DeviceUse::cpu) return runs;
  if (use_ == DeviceUse::automatic && !is_large(members))
    runs->refuse("the sweep is too small for the GPU");
  else if (find(why))
    runs->prepare(members, *compiler_, device_);
  else
    runs->refuse(why);
  return runs;
}

}  // namespace stepwire::device
