#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/call_options.hpp"
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

struct LinearizeCall {
  std::string file;
  LoadWords words;
  session::LinearCall linear;
  std::string at;        ///< time; empty: 0
  std::string feedback;  ///< positive or negative; empty: default of the analysis
  bool trim = false;     ///< linearize at the operating point of the section `trim`
  std::string out;       ///< folder; empty: no files
  bool json = false;
};

double time_of(const std::string& text) {
  const auto time = unit::parse_quantity(text);
  const bool fits = time && (!time->dimension || *time->dimension == unit::parse_unit("s")->dimension);
  if (!fits) throw yaml::Error(yaml::Fault{{"--at " + text, {}}, "", "is no time; write e.g. --at 2s", {}});
  return time->value;
}

/// Adds the trimmed operating point to the settings. Throws Error if the trim has not converged.
void add_trimmed(const std::string& file, const Registry& registry, session::LoadOptions& options) {
  const linear::TrimResult found = session::trim_file(registry, file, options);
  if (!found.converged)
    throw yaml::Error(yaml::Fault{
        {file, {}}, "trim", "no such point was found; 'stepwire trim' tells how far it came", {}});
  for (diagram::Setting& setting : session::settings_of(found))
    options.settings.push_back(std::move(setting));
}

ExitCode linearize(const LinearizeCall& call, const Registry& registry) {
  session::LinearCall linear = call.linear;
  if (!call.at.empty()) linear.time = time_of(call.at);
  if (!call.feedback.empty()) linear.feedback = call.feedback == "positive" ? 1.0 : -1.0;
  session::LoadOptions options = load_options(call.words);
  if (call.trim) add_trimmed(call.file, registry, options);
  const linear::Analysis analysis = session::linearize_file(registry, call.file, options, linear);
  if (!call.out.empty()) session::write_linear(call.out, analysis);
  if (call.json)
    put_json(result::json_of(analysis));
  else
    put_text(report::linear_text(analysis));
  if (!call.out.empty() && !call.json) say("  written to {}\n", call.out);
  return ExitCode::done;
}

/// Adds the options for inputs, outputs and opened loops.
void add_signal_options(CLI::App& verb, session::LinearCall& linear) {
  const auto names = [&](const char* option, std::vector<std::string>& into, const char* about) {
    verb.add_option(option, into, about)->delimiter(',')->expected(1, -1);
  };
  names("--from", linear.from, "signals to which something is added; all inputs without it");
  names("--to", linear.to, "signals that are looked at; all outputs without it");
  names("--open", linear.open, "signals whose wires are cut, and held as they are");
}

Action declare_linearize(CLI::App& verb) {
  const auto call = std::make_shared<LinearizeCall>();
  verb.add_option("FILE", call->file, "a diagram file")->required();
  add_signal_options(verb, call->linear);
  CLI::Option* const at = verb.add_option("--at", call->at, "when in the run: 2s; at its start without it");
  verb.add_flag("--trim", call->trim, "at the point of the file's section 'trim'")->excludes(at);
  verb.add_option("--difference", call->linear.size,
                  "size of differences, a share of each number or of 1; without it many are tried")
      ->check(CLI::Range(1e-12, 1.0));
  verb.add_option("--feedback", call->feedback,
                  "how the loop is closed for margins; negative, but positive where --from, --to and "
                  "--open are one wire")
      ->check(choice({"negative", "positive"}));
  verb.add_option("--out", call->out, "folder for linear.json and linear.mat")->type_name("DIR");
  verb.add_flag("--json", call->json, "print the result as JSON");
  add_load_options(verb, call->words);
  return [call](const Registry& registry) {
    Json faults;
    const ExitCode code = guarded([&] { return linearize(*call, registry); }, &faults);
    if (call->json && faults.is_list())
      put_json(Json::object().set("file", call->file).set("faults", std::move(faults)));
    return code;
  };
}

}  // namespace

Verb linearize_verb() {
  return {"linearize", "find the linear system of a diagram near a point: poles, zeros, margins",
          "Example:\n  stepwire linearize cart.yaml --from push --to cart.position --at 2s --out out/cart",
          declare_linearize};
}

}  // namespace stepwire::cli
