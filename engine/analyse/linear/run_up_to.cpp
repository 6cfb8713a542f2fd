#include "engine/analyse/linear/run_up_to.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/simulate/run/drive.hpp"

namespace stepwire::linear {

namespace {

[[noreturn]] void refuse(const yaml::Place& place, double time, const std::string& why) {
  throw yaml::Error(
      yaml::Fault{place, "at", yaml::fault_text("{} s is not within the run; {}", time, why), {}});
}

}  // namespace

std::unique_ptr<run::Executor> run_up_to(const plan::Plan& plan, double time, std::int64_t base_ticks,
                                         const yaml::Place& place) {
  if (!(time >= 0.0 && time <= plan.diagram.stop))
    refuse(
        place, time,
        fmt::format("it goes from 0 to {} s; give a time within it, or a later 'stop'", plan.diagram.stop));
  auto run = std::make_unique<run::Executor>(plan);
  const auto wanted = static_cast<std::int64_t>(std::llround(time / plan.diagram.step));
  const std::int64_t end = (wanted + base_ticks - 1) / base_ticks * base_ticks;
  std::vector<record::Recorder> nothing_recorded;
  run::Drive drive(*run, nothing_recorded);
  drive.judges_steps = false;
  drive.until = end;
  if (drive.run() == run::Drive::End::paused) return run;
  if (const auto fault = run->fault()) throw yaml::Error(fault->fault);
  refuse(place, time,
         fmt::format("'stop_when'{} ends it at {:.12g} s; give an earlier time", run->has_stopped() ? " or a block" : "",
                     run->time()));
}

void require_linear(const plan::Plan& plan) {
  yaml::Faults faults;
  for (const diagram::DiagramBlock& block : plan.diagram.blocks)
    if (const BlockType& type = block.type(); !type.delayed_by.empty())
      faults.add(plan.diagram.fault(
          block.origin, block.name,
          fmt::format(
              "{} cannot be linearised here: beside blocks that act at ticks it has no finite number of "
              "states; put a Delay of whole sample times in its place, or a TransferFunction that "
              "approximates it",
              type.name)));
  faults.throw_if_any();
}

}  // namespace stepwire::linear
