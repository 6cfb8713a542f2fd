#include "engine/simulate/run/lane_runner.hpp"

#include <algorithm>
#include <chrono>

#include "engine/simulate/run/drive.hpp"

namespace stepwire::run {

namespace {

constexpr std::int64_t tried = 1024;  // ticks of the speed measurement

/// Shortest measured time of an interval of ticks [s]. The minimum is the best estimate because other load
/// only lengthens it.
class Shortest {
 public:
  template <class Work>
  void measure(const Work& work) {
    const auto start = Clock::now();
    work();
    seconds_ = std::min(seconds_, std::chrono::duration<double>(Clock::now() - start).count());
  }
  double seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_ = 1e9;
};

/// True if lanes are expected to be faster: a step of all lanes takes two to three times as long as a step of
/// one run.
bool pays(std::size_t runs, int lanes) {
  return 10 * runs >= 3 * static_cast<std::size_t>(lanes);
}

}  // namespace

std::size_t LaneRunner::at_once(std::size_t member) const {
  const plan::CompiledLanes* code = code_.code(member);
  return code ? static_cast<std::size_t>(code->lanes) : 1;
}

bool LaneRunner::run(std::size_t member, const plan::CompiledPlan* alone, std::vector<PendingRun>& runs) {
  const plan::CompiledLanes* code = code_.code(member);
  if (!code || (use_ != LaneUse::at_once && !pays(runs.size(), code->lanes))) return false;
  std::vector<LaneGroup::Run> lanes;
  for (PendingRun& run : runs) lanes.push_back({run.simulation, run.recorders});
  LaneGroup group(*code, std::move(lanes));
  if (!group.fits()) {
    code_.decide(member, "its runs differ in numbers that the code has for all");
    return false;
  }
  if (!stays(member, group, alone, runs)) return false;
  go_on(group);
  const std::uint32_t interrupted = group.interrupt();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    RunEnd& end = runs[i].end = end_of(*runs[i].simulation);
    end.interrupted = (interrupted >> i & 1u) != 0;
    end.compiled_ticks = end.lane_ticks = end.ticks;
  }
  return true;
}

/// Decides once, by measurement, whether a member's runs stay in lanes. If not, resets the runs and
/// recorders.
bool LaneRunner::stays(std::size_t member, LaneGroup& group, const plan::CompiledPlan* alone,
                       std::vector<PendingRun>& runs) {
  if (code_.is_decided(member) || use_ == LaneUse::at_once) return true;
  if (is_faster(group, *runs.front().simulation, alone)) {
    code_.decide(member);
    return true;
  }
  code_.decide(member, "the runs are faster one by one");
  for (PendingRun& run : runs) {
    run.simulation->reset();
    for (record::Recorder& recorder : *run.recorders) recorder.go_back_to(0);
  }
  return false;
}

/// Measures the first ticks in lanes and alone. The lanes keep their ticks; the single run is reset.
bool LaneRunner::is_faster(LaneGroup& group, Executor& alone, const plan::CompiledPlan* code) const {
  Shortest together, one;
  if (!code) return true;
  alone.use(*code);
  std::vector<record::Recorder> none;
  Drive drive(alone, none);
  drive.judges_steps = false;
  Drive::End how = Drive::End::paused;
  for (drive.until = 0; how == Drive::End::paused && drive.until < tried;) {
    drive.until += LaneGroup::ticks_at_once;
    one.measure([&] { how = drive.run(); });
  }
  alone.reset();
  while (group.goes_on() && group.tick() < tried)
    together.measure([&] { group.step(LaneGroup::ticks_at_once); });
  return together.seconds() < static_cast<double>(group.runs()) * one.seconds();
}

void LaneRunner::go_on(LaneGroup& group) {
  std::int64_t looked = group.tick();
  while (group.goes_on()) {
    group.step(LaneGroup::ticks_at_once);
    if (group.tick() - looked < Drive::ticks_between_looks) continue;
    looked = group.tick();
    if (interrupt_ && *interrupt_) return;
  }
}

}  // namespace stepwire::run
