#include <cmath>

#include "engine/app/session/loop_files.hpp"
#include "engine/app/session/run_files.hpp"
#include "engine/app/session/version.hpp"
#include "engine/model/diagram/flatten.hpp"
#include "engine/simulate/realtime/machine.hpp"

namespace stepwire::session {

using json::Json;

namespace {

Json or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

/// Returns the nonempty bins as [[begin, count], ...].
Json bins_json(const realtime::Histogram& times) {
  Json bins = Json::list();
  for (std::size_t bin = 0; bin < realtime::Histogram::bins(); ++bin)
    if (times.count_in(bin) > 0)
      bins.push(Json::list({Json(realtime::Histogram::begin_of(bin)), Json(times.count_in(bin))}));
  return bins;
}

Json times_json(const realtime::Histogram& times) {
  return Json::object()
      .set("count", times.count())
      .set("min", times.min())
      .set("mean", times.mean())
      .set("p50", times.quantile(0.5))
      .set("p99", times.quantile(0.99))
      .set("p99.9", times.quantile(0.999))
      .set("max", times.max())
      .set("histogram", bins_json(times));
}

Json worst_json(const LoopOutcome& outcome) {
  Json wake_up = Json::list(), response = Json::list(), step = Json::list();
  for (const realtime::Measurements::Worst& worst : outcome.loop.measurements().worst()) {
    wake_up.push(worst.wake_up);
    response.push(worst.response);
    step.push(worst.step);
  }
  const double stretch = outcome.settings.duration / static_cast<double>(realtime::Measurements::worst_count);
  return Json::object()
      .set("stretch_s", stretch)
      .set("wake_up", std::move(wake_up))
      .set("response", std::move(response))
      .set("step", std::move(step));
}

Json groups_json(const LoopOutcome& outcome) {
  Json groups = Json::list();
  for (const realtime::GroupCost& cost : outcome.loop.group_costs())
    groups.push(Json::object()
                    .set("type", cost.type)
                    .set("blocks", cost.blocks)
                    .set("mean", cost.samples > 0 ? Json(cost.mean) : Json())
                    .set("samples", cost.samples));
  return Json::object()
      .set("how", "one stretch of calls of a tick at each wake-up, chosen pseudo-randomly")
      .set("types", std::move(groups));
}

Json thread_json(const LoopOutcome& outcome) {
  const realtime::ThreadCounts& counts = outcome.loop.counts();
  return Json::object()
      .set("policy", outcome.served.policy)
      .set("cpu", outcome.settings.cpu ? Json(*outcome.settings.cpu) : Json())
      .set("spin", outcome.settings.spin)
      .set("refused", Json::list_of(outcome.served.refused))
      .set("minor_faults", counts.minor_faults)
      .set("major_faults", counts.major_faults)
      .set("allocations", counts.allocations ? Json(*counts.allocations) : Json())
      .set("voluntary_switches", counts.voluntary)
      .set("involuntary_switches", counts.involuntary);
}

Json rows_json(const std::optional<LoopRows>& rows) {
  if (!rows) return {};
  return Json::object()
      .set("written", rows->written)
      .set("lost_to_ring", rows->lost_to_ring)
      .set("lost_to_disk", rows->lost_to_disk);
}

Json baseline_json(const std::optional<realtime::Cyclictest>& baseline) {
  if (!baseline) return {};
  const realtime::CyclictestHistogram& times = baseline->histogram();
  return Json::object()
      .set("command", baseline->command())
      .set("count", times.count())
      .set("p50_us", times.quantile(0.5))
      .set("p99_us", times.quantile(0.99))
      .set("p99.9_us", times.quantile(0.999))
      .set("max_us", times.max());
}

Json machine_json() {
  const realtime::Machine machine = realtime::Machine::here();
  return Json::object()
      .set("processor", machine.processor)
      .set("processors", machine.processors)
      .set("virtual", machine.virtual_machine)
      .set("kernel", machine.kernel)
      .set("kernel_command_line", machine.kernel_line)
      .set("governor", or_null(machine.governor))
      .set("clock_source", or_null(machine.clock_source))
      .set("isolated", or_null(machine.isolated));
}

Json deadlines_json(const LoopOutcome& outcome) {
  const realtime::Deadlines& deadlines = outcome.loop.deadlines();
  return Json::object()
      .set("planned", outcome.settings.deadlines)
      .set("passed", deadlines.index())
      .set("missed", deadlines.missed())
      .set("late", deadlines.late())
      .set("dropped", deadlines.dropped())
      .set("longest_row", deadlines.longest_row());
}

Json diagram_json(const run::Executor& simulation) {
  const plan::Plan& plan = simulation.plan();
  return Json::object()
      .set("file", plan.diagram.file)
      .set("title", plan.diagram.title)
      .set("hash", diagram::diagram_hash(plan.diagram))
      .set("blocks", plan.diagram.blocks.size())
      .set("states", plan.layout.state_count + plan.layout.discrete_count)
      .set("step_s", plan.diagram.step)
      .set("engine", simulation.compiled() ? "compiled" : "interpreted");
}

}  // namespace

Json loop_json(const LoopOutcome& outcome) {
  const realtime::Loop& loop = outcome.loop;
  Json faults = Json::list();
  if (const auto fault = loop.simulation().fault()) faults.push(fault->fault.text());
  return Json::object()
      .set("diagram", diagram_json(loop.simulation()))
      .set("end", end_word(loop.end()))
      .set("faults", std::move(faults))
      .set("rate_hz", outcome.settings.rate)
      .set("duration_s", outcome.settings.duration)
      .set("steps", loop.steps())
      .set("ticks", loop.simulation().tick())
      .set("deadlines", deadlines_json(outcome))
      .set("algebraic_loops", algebraic_loops_json(loop.simulation().loop_costs()))
      .set("resolution", realtime::Histogram::resolution)
      .set("wake_up", times_json(loop.measurements().wake_up()))
      .set("response", times_json(loop.measurements().response()))
      .set("step", times_json(loop.measurements().step()))
      .set("worst", worst_json(outcome))
      .set("block_types", groups_json(outcome))
      .set("thread", thread_json(outcome))
      .set("rows", rows_json(outcome.rows))
      .set("cyclictest", baseline_json(outcome.baseline))
      .set("machine", machine_json())
      .set("version", program_version())
      .set("compiler", compiler_version());
}

std::string end_word(realtime::Loop::End end) {
  switch (end) {
    case realtime::Loop::End::stopped:
      return "stopped after too many misses in a row";
    case realtime::Loop::End::interrupted:
      return "interrupted";
    case realtime::Loop::End::fault:
      return "ended by the diagram";
    case realtime::Loop::End::done:
      break;
  }
  return "done";
}

}  // namespace stepwire::session
