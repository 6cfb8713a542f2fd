#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/run_call.hpp"
#include "engine/app/cli/verb.hpp"

namespace stepwire::cli {

namespace {

Action declare_tune(CLI::App& verb) {
  const auto call = std::make_shared<RunCall>();
  call->requires_section = "tune";
  add_run_options(verb, *call,
                  "folder for parameters.yaml, tune.json, tune-history.csv and all that run writes");
  session::TuneCall& tune = call->tune;
  verb.add_option("--starts", tune.starts, "how many searches, in place of the file's")
      ->check(CLI::Range(1, 10'000));
  verb.add_option("--evaluations", tune.evaluations, "of one search at most, in place of the file's")
      ->check(CLI::Range(1, 10'000'000));
  verb.add_option("--seed", tune.seed, "of what is random, in place of the file's");
  verb.add_option("--repeat", tune.experiments,
                  "experiments of one evaluation of a study, in place of the file's")
      ->check(CLI::Range(1, 1'000'000));
  verb.add_option("--threads", tune.threads, "how many threads; all cores without it");
  return [call](const Registry& registry) { return run_models(*call, registry); };
}

}  // namespace

Verb tune_verb() {
  return {"tune", "find parameters that make an objective small while claims hold, then run with them",
          "Example:\n  stepwire tune loop.yaml --starts 8 --out out/loop\n"
          "The exit code is 1 without convergence; all files are written.",
          declare_tune};
}

}  // namespace stepwire::cli
