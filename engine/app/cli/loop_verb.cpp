#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/call_options.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/model_call.hpp"
#include "engine/app/cli/monitoring.hpp"
#include "engine/app/cli/real_time_call.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/report/loop_text.hpp"
#include "engine/app/session/loop_run.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::cli {
namespace {

ExitCode code_of_loop(const session::LoopOutcome& outcome) {
  switch (outcome.loop.end()) {
    case realtime::Loop::End::stopped:
      return ExitCode::fails;
    case realtime::Loop::End::interrupted:
      return ExitCode::interrupted;
    case realtime::Loop::End::fault:
      return ExitCode::wrong;
    case realtime::Loop::End::device:
      return ExitCode::surroundings;
    case realtime::Loop::End::done:
      break;
  }
  return ExitCode::done;
}

/// Prints the faults of a loop on the standard error.
ExitCode print_troubles(const session::LoopOutcome& outcome) {
  ExitCode code = code_of_loop(outcome);
  if (const auto fault = outcome.loop.simulation().fault()) complain("{}\n", fault->fault.text());
  if (!outcome.device_fault.empty()) {
    complain("{}\n", text::visible(outcome.device_fault));
    code = worst(code, ExitCode::surroundings);
  }
  if (!outcome.rows || outcome.rows->trouble.empty()) return code;
  complain("{}; {} rows are lost\n", outcome.rows->trouble, outcome.rows->lost_to_disk);
  return worst(code, ExitCode::surroundings);
}

void add_loop_options(CLI::App& verb, session::LoopCall& call) {
  session::LoopWords& words = call.words;
  verb.add_option("FILE", call.file, "a diagram file")->required();
  verb.add_option("--duration", words.duration, "for how long [s]; the file's stop does not end it")
      ->capture_default_str();
  add_timing_options(verb, words);
  add_engine_option(verb, call.engine, "interpreted, or compiled before the loop begins; to the same bits");
  verb.add_option("--io", call.io, "file that says which input and output is which channel of which device")
      ->type_name("RIG.yaml");
  verb.add_option("--out", call.out, "folder for signals.csv, inputs.csv, loop.json, loop.svg");
  verb.add_flag("--baseline", call.baseline, "measure cyclictest by turns, and set it beside the loop");
}

}  // namespace

ExitCode run_in_real_time(const session::LoopCall& call, const Registry& registry) {
  const EndDelay delay(EndDelay::Signals::all);
  ExitCode code = ExitCode::done;
  session::run_loop(call, registry, terminal_monitor(nullptr), [&](const session::LoopOutcome& outcome) {
    put_report(report::loop_text(outcome), code_of_loop(outcome) == ExitCode::fails);
    code = print_troubles(outcome);
  });
  if (!call.out.empty()) say("  written to {}\n", call.out);
  return code;
}

namespace {

Action declare_loop(CLI::App& verb) {
  const auto call = std::make_shared<session::LoopCall>();
  const auto words = std::make_shared<LoadWords>();
  add_loop_options(verb, *call);
  add_load_options(verb, *words);
  return [call, words](const Registry& registry) {
    call->load = load_options(*words);
    return run_in_real_time(*call, registry);
  };
}

}  // namespace

Verb loop_verb() {
  return {"loop", "run a diagram file in real time, and measure how well",
          "Example:\n  stepwire loop lag.yaml --rate 1000 --duration 10 --overrun stop:3 --out out/lag",
          declare_loop};
}

}  // namespace stepwire::cli
