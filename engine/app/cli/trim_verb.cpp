#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/model_call.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/report/linear_text.hpp"
#include "engine/app/session/fault_json.hpp"
#include "engine/app/session/linearizing.hpp"

namespace stepwire::cli {

using json::Json;

namespace {

struct TrimCall {
  std::string file;
  LoadWords words;
  std::string out;  ///< folder; empty: no files
  bool json = false;
};

ExitCode find_point(const TrimCall& call, const Registry& registry) {
  const linear::TrimResult result = session::trim_file(registry, call.file, load_options(call.words));
  if (!call.out.empty()) session::write_trim(call.out, result);
  if (call.json)
    put_json(result::json_of(result));
  else
    put_report(report::trim_text(result), !result.converged);
  if (!call.out.empty() && !call.json) say("  written to {}\n", call.out);
  return result.converged ? ExitCode::done : ExitCode::fails;
}

Action declare_trim(CLI::App& verb) {
  const auto call = std::make_shared<TrimCall>();
  verb.add_option("FILE", call->file, "a diagram file with a section 'trim'")->required();
  verb.add_option("--out", call->out, "folder for parameters.yaml, which --set-from takes, and trim.json")
      ->type_name("DIR");
  verb.add_flag("--json", call->json, "print the result as JSON");
  add_load_options(verb, call->words);
  return [call](const Registry& registry) {
    Json faults;
    const ExitCode code = guarded([&] { return find_point(*call, registry); }, &faults);
    if (call->json && faults.is_list())
      put_json(Json::object().set("file", call->file).set("faults", std::move(faults)));
    return code;
  };
}

}  // namespace

Verb trim_verb() {
  return {"trim", "find an operating point of a diagram, where it stands still",
          "Example:\n  stepwire trim pendulum.yaml --out out/upright\n"
          "The exit code is 1 without convergence; all files are written.",
          declare_trim};
}

}  // namespace stepwire::cli
