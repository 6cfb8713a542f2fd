#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <functional>
#include <thread>

#include "blocks/register.hpp"
#include "engine/app/fmu/unit_export.hpp"
#include "engine/app/fmu/variables.hpp"
#include "engine/base/fmi/archive_bytes.hpp"
#include "engine/base/io/file.hpp"
#include "engine/simulate/codegen/between_ticks.hpp"
#include "engine/simulate/run/run.hpp"
#include "tests/diagrams/diagram_files.hpp"
#include "tests/support/units/schema.hpp"

using namespace stepwire;

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t ticks = 200;

/// A unit of a diagram, and what it is compared by.
struct Exported {
  std::string file, refused, invalid;
  bool exchanges = false;
};

Exported export_job(const run::Job& job, int version, const codegen::Compiler& compiler,
                    const std::string& stem) {
  Exported made;
  try {
    const codegen::Tuning tuning = codegen::tuning_of(job.plan);
    // Optimised or not, the bits are the same; compiling is faster.
    const auto unit = fmu::export_unit(
        job.plan, tuning, {.version = version, .name = "unit", .made_by = "a test", .flags = {"-O0"}},
        compiler);
    made.file = stem + ".fmu";
    made.exchanges = unit.no_exchange.empty();
    io::write_file(made.file, fmi::archive_bytes(unit.files));
    io::write_file(stem + ".xml", unit.files.at("modelDescription.xml"));
    made.invalid = testing::schema_fault(stem + ".xml", version);
  } catch (const std::exception& error) {
    made.refused = error.what();
  }
  return made;
}

/// A diagram whose one block is the unit, with the step and the solver of the other.
plan::Plan importing(const run::Job& job, const Exported& made, const char* interface) {
  const diagram::Diagram& own = job.plan.diagram;
  std::string text = fmt::format("stepwire: 1\ntitle: an exported unit\nstep: {} s\nstop: {} s\n", own.step,
                                 own.step * static_cast<double>(ticks));
  if (const auto& control = own.error_control)
    text += fmt::format("solver: {{name: {}, relative: {:.17g}, absolute: {:.17g}, max_steps: {}}}\n",
                        own.solver, control->relative, control->absolute, control->max_steps);
  else if (!own.solver.empty())
    text += "solver: " + own.solver + "\n";
  if (own.events.locate) text += "events: locate\n";
  text += fmt::format("blocks:\n  unit: {{block: Fmu, file: {}, interface: {}}}\n", made.file, interface);
  static const Registry registry = blocks();
  io::write_file(made.file + ".yaml", text);
  return plan::make_plan(diagram::Loader(registry).load(made.file + ".yaml"));
}

/// Numbers of an output as FMI has them: rows of a matrix behind each other.
std::vector<double> numbers_of(const run::Executor& run, const plan::SignalSlot& slot) {
  std::vector<double> numbers;
  for (Index k = 0; k < slot.size; ++k)
    numbers.push_back(run.values()[slot.offset + static_cast<std::size_t>(k % slot.columns * slot.rows() +
                                                                          k / slot.columns)]);
  return numbers;
}

/// The signals that the outputs of a unit are, in their order.
std::vector<std::pair<std::string, plan::SignalSlot>> outputs_of(const plan::Plan& plan, bool exchange) {
  std::map<std::string, plan::SignalSlot> slots;
  for (const diagram::RecordRequest& request : plan.diagram.records)
    for (const diagram::RecordedSignal& signal : request.signals)
      slots.emplace(signal.name, plan.slot(signal.signal));
  for (const diagram::DiagramOutput& output : plan.diagram.outputs)
    slots.insert_or_assign(output.name, plan.slot(output.signal));
  std::vector<std::pair<std::string, plan::SignalSlot>> outputs;
  for (const fmu::Variable& variable : fmu::variables_of(plan, codegen::tuning_of(plan), exchange))
    if (variable.causality == "output") outputs.emplace_back(variable.name, slots.at(variable.name));
  return outputs;
}

/// Where the run of the unit parts from that of the diagram; empty where it never does.
std::string difference(const run::Job& job, const Exported& made, const char* interface) {
  const plan::Plan outer = importing(job, made, interface);
  run::Executor own(job.plan), unit(outer);
  const auto outputs = outputs_of(job.plan, made.exchanges);
  const std::vector<plan::SignalSlot>& shown = outer.blocks[0].outputs;
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    own.evaluate();
    unit.evaluate();
    if (!own.healthy() || !unit.healthy())
      return own.healthy() == unit.healthy() ? "" : "only one run has failed";
    std::size_t port = 0, place = 0;
    for (const auto& [name, slot] : outputs)
      for (const double number : numbers_of(own, slot)) {
        const plan::SignalSlot& of = shown[port];
        const double other = unit.values()[of.offset + place];
        if (std::memcmp(&number, &other, sizeof number) != 0)
          return fmt::format("{} at tick {}: {} and not {}", name, tick, other, number);
        if (++place == static_cast<std::size_t>(of.size)) ++port, place = 0;
      }
    if (port != shown.size()) return fmt::format("{} outputs of {}", port, shown.size());
    own.advance();
    unit.advance();
  }
  return "";
}

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back([&] {
      for (std::size_t at = next++; at < count; at = next++) work(at);
    });
}

}  // namespace

// Every second diagram is a unit of FMI 2, the others are of FMI 3.
TEST_CASE(
    "every diagram that can be generated is a valid unit, which has the diagram's bits when it is imported") {
  const codegen::Compiler compiler;
  if (!compiler.found()) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  std::vector<run::Job> jobs;
  for_every_job([&](run::Job job) { jobs.push_back(std::move(job)); });
  const fs::path folder = fs::temp_directory_path() / fmt::format("stepwire-exported-{}", ::getpid());
  fs::create_directories(folder);
  std::vector<Exported> made(jobs.size());
  in_parallel(jobs.size(), [&](std::size_t i) {
    made[i] = export_job(jobs[i], i % 2 == 0 ? 3 : 2, compiler, (folder / std::to_string(i)).string());
  });
  std::size_t exchanges = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    INFO(jobs[i].plan.diagram.file);
    if (!made[i].refused.empty()) {
      WARN("cannot be exported: " << made[i].refused);
      continue;
    }
    CHECK(made[i].invalid == "");
    CHECK(difference(jobs[i], made[i], "co_simulation") == "");
    if (!made[i].exchanges) continue;
    ++exchanges;
    CHECK(difference(jobs[i], made[i], "model_exchange") == "");
  }
  CHECK(exchanges > 10);
  fs::remove_all(folder);
}
