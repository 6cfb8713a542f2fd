#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/model_call.hpp"
#include "engine/app/cli/monitoring.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/session/fault_json.hpp"
#include "engine/app/session/mutating.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::cli {
namespace {

struct MutateCall {
  std::string file;
  LoadWords words;
  unsigned threads = 0;
  bool json = false;
};

std::string mutations_text(const session::MutationResult& result) {
  std::string text = fmt::format("{}\n  {}: {} noticed by {}, {} survive, {} refused\n", result.file,
                                 text::counted(result.mutations.size(), "mutation"), result.noticed(),
                                 text::counted(result.claims, "claim"), result.survived(), result.refused());
  for (const session::TriedMutation& one : result.mutations)
    if (one.outcome == session::MutationOutcome::survives)
      text += fmt::format("  FAIL {}: {} in place of {} breaks no claim\n", text::visible(one.what),
                          text::visible(one.version), text::visible(one.old));
  for (const std::string& one : result.left_out)
    text += fmt::format("  not mutated: parameter {}\n", text::visible(one));
  return text;
}

ExitCode mutate_file(const MutateCall& call, const Registry& registry) {
  const EndDelay delay(EndDelay::Signals::first);
  const session::MutationResult result = [&] {
    Progress progress("mutate");
    return session::mutate(registry, call.file, load_options(call.words), terminal_monitor(&progress),
                           call.threads);
  }();
  if (call.json)
    put_json(result::json_of(result));
  else
    put_report(mutations_text(result), result.survived() > 0);
  if (result.interrupted) return ExitCode::interrupted;
  return result.survived() > 0 ? ExitCode::fails : ExitCode::done;
}

Action declare_mutate(CLI::App& verb) {
  const auto call = std::make_shared<MutateCall>();
  verb.add_option("FILE", call->file, "a diagram file with claims that hold")->required();
  verb.add_option("--threads", call->threads, "how many mutations are run at once; all cores without it");
  verb.add_option("--stop", call->words.stop, "another end of the runs: 2s");
  verb.add_flag("--json", call->json, "print the result as JSON");
  add_load_options(verb, call->words);
  return [call](const Registry& registry) {
    json::Json faults;
    const ExitCode code = guarded([&] { return mutate_file(*call, registry); }, &faults);
    if (call->json && faults.is_list())
      put_json(json::Json::object().set("file", call->file).set("faults", std::move(faults)));
    return code;
  };
}

}  // namespace

Verb mutate_verb() {
  return {"mutate", "change a diagram in many ways, and list the changes that no claim notices",
          "Example:\n  stepwire mutate lag.yaml\n"
          "The exit code is 0 if a claim fails after each change, and 1 if a change breaks none.",
          declare_mutate};
}

}  // namespace stepwire::cli
