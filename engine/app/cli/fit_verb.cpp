#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/run_call.hpp"
#include "engine/app/cli/verb.hpp"

namespace stepwire::cli {

namespace {

Action declare_fit(CLI::App& verb) {
  const auto call = std::make_shared<RunCall>();
  call->requires_section = "fit";
  add_run_options(verb, *call, "folder for parameters.yaml, fit.json and all that run writes");
  session::FitCall& fit = call->fit;
  verb.add_option("--follow", fit.follow, "how many of the searches go on, in place of the file's")
      ->check(CLI::Range(1, 10'000));
  verb.add_option("--starts", fit.starts, "how many searches, in place of the file's")
      ->check(CLI::Range(1, 10'000));
  verb.add_option("--seed", fit.seed, "of random starts, in place of the file's");
  verb.add_option("--threads", fit.threads, "how many threads; all cores without it");
  return [call](const Registry& registry) { return run_models(*call, registry); };
}

}  // namespace

Verb fit_verb() {
  return {"fit", "find parameters of diagram files from records, then run them",
          "Example:\n  stepwire fit press.yaml --starts 8 --out out/press\n"
          "The exit code is 1 without convergence, and with --strict also where a note doubts the fit; all "
          "files are written.",
          declare_fit};
}

}  // namespace stepwire::cli
