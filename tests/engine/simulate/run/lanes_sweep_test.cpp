#include <catch2/catch.hpp>
#include <cstring>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/run.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::codegen {

namespace {

/// x grows by its rate k: some runs end by `stop_when`, one by a number that is not finite, others at the
/// stop.
const std::string growing =
    "stepwire: 1\nstep: 10 ms\nstop: 2 s\nsolver: rk4\nparameters: {k: 1}\n"
    "blocks:\n  rate: {block: Gain, gain: $k, u: x}\n  x: {block: Integrator, u: rate, initial: 1}\n"
    "  clock: {block: Sine, frequency: 1 Hz}\n"
    "stop_when: x > 4\nrecord: {every: 30 ms, signals: [x, rate, clock]}\n"
    "sweep: {k: [0.1, -1, 1e200, 0.9, 2, 400, 0.5, 0.2, 3, -2, 0.7, 1.1, 1.2]}\n";

/// Blocks that read lists of vectors, of which some differ between the runs.
const std::string lists =
    "stepwire: 1\nstep: 10 ms\nstop: 0.5 s\nparameters: {k: 1}\nblocks:\n"
    "  wave: {block: Sine, amplitude: [1, 2], frequency: 1 Hz}\n  scaled: {block: Gain, gain: $k, u: wave}\n"
    "  beside: {block: Concatenate, u: [scaled, [0.5, 0.25], wave]}\n"
    "  below: {block: Stack, u: [beside, beside]}\n  behind: {block: Mux, u: [wave, scaled]}\n"
    "  watched: {block: Interlock, u: scaled, faults: [-1], measured: [wave, scaled]}\n"
    "record: all\nsweep: {k: [0.1, -1, 0.9, 2, 0.5]}\n";

/// Sources of the time alone, with and without jumps, before a loop that differs between the runs.
std::string sources(const std::string& solver) {
  return "stepwire: 1\nstep: 10 ms\nsolver: " + solver +
         "\nstop: 2 s\nparameters: {k: 1}\nblocks:\n"
         "  wave: {block: Sine, amplitude: [1, 2], frequency: 1.7 Hz}\n"
         "  pulse: {block: Pulse, period: 0.37 s, width: 0.3}\n  now: {block: Clock}\n"
         "  curve: {block: Expression, u: now, expression: exp(-u) * sin(9 * u)}\n"
         "  total: {block: Sum, u: [wave.1, wave.2, pulse, curve]}\n"
         "  gap: {block: Sum, signs: +-, u: [total, x]}\n  rate: {block: Gain, gain: $k, u: gap}\n"
         "  x: {block: Integrator, u: rate}\nrecord: all\nsweep: {k: [0.5, 1, 2, 3, 4, 5, 6, 7, 8, 9]}\n";
}

run::RunResult swept(run::LaneUse lanes, unsigned threads = 2, const std::string& text = growing) {
  const DiagramFolder folder;
  folder.write("sweep.yaml", text);
  diagram::Loader loader(library());
  const run::Job job = run::make_job(loader, folder.path("sweep.yaml"));
  GeneratedCode code{run::code_trial()};
  run::RunOptions options;
  options.threads = threads;
  options.engine = run::ExecutionMode::compiled;
  options.code = &code;
  options.lanes = lanes;
  return run::run_job(job, options);
}

bool same_bits(const table::Table& a, const table::Table& b) {
  if (a.columns.size() != b.columns.size()) return false;
  for (std::size_t i = 0; i < a.columns.size(); ++i) {
    const auto &x = a.columns[i].values, &y = b.columns[i].values;
    if (x.size() != y.size() || std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) != 0) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("runs of a sweep end in lanes as they end alone") {
  const run::RunResult alone = swept(run::LaneUse::never), together = swept(run::LaneUse::at_once);
  INFO(together.lanes.why_not);
  CHECK(alone.lanes.count == 1);
  CHECK(alone.lane_ticks == 0);
  CHECK_FALSE(alone.lanes.why_not.empty());
  CHECK(same_bits(alone.recordings.front().table, together.recordings.front().table));
  CHECK(alone.ticks == together.ticks);
  REQUIRE(alone.faults.size() == 1);
  REQUIRE(together.faults.size() == 1);
  CHECK(alone.faults[0].fault.message == together.faults[0].fault.message);
  const Compiler compiler;
  if (!compiler.found() || !compiler.is_gcc() || !__builtin_cpu_supports("avx2")) return;
  CHECK(together.lanes.why_not == "");
  CHECK(together.lanes.count == (__builtin_cpu_supports("avx512f") ? 8 : 4));
  CHECK(together.lane_ticks > together.ticks / 2);
}

TEST_CASE("what a sweep gives in lanes does not hang on the number of threads") {
  CHECK(same_bits(swept(run::LaneUse::at_once, 1).recordings.front().table,
                  swept(run::LaneUse::at_once, 3).recordings.front().table));
}

TEST_CASE("elements of a list of vectors are those of their own lane") {
  const run::RunResult alone = swept(run::LaneUse::never, 1, lists),
                       together = swept(run::LaneUse::at_once, 1, lists);
  INFO(together.lanes.why_not);
  CHECK(same_bits(alone.recordings.front().table, together.recordings.front().table));
  const Compiler compiler;
  if (compiler.found() && compiler.is_gcc() && __builtin_cpu_supports("avx2")) CHECK(together.lane_ticks > 0);
}

TEST_CASE("numbers of the time alone are computed ahead for the times of each solver, with the same bits",
          "[full]") {
  for (const char* solver : {"euler", "heun", "bogacki_shampine", "rk4", "dormand_prince"}) {
    INFO(solver);
    const run::RunResult alone = swept(run::LaneUse::never, 1, sources(solver)),
                         together = swept(run::LaneUse::at_once, 1, sources(solver));
    CHECK(same_bits(alone.recordings.front().table, together.recordings.front().table));
    CHECK((together.lanes.count == 1 || together.lanes.why_not == ""));
  }
}

}  // namespace stepwire::codegen
