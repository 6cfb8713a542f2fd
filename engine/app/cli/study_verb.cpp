#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/run_call.hpp"
#include "engine/app/cli/verb.hpp"

namespace stepwire::cli {

namespace {

void add_study_options(CLI::App& verb, RunCall& call) {
  study::StudyWords& words = call.models.study;
  verb.add_option("--subjects", words.subjects, "how many people, in place of the file's")
      ->check(CLI::Range(1, 1000));
  verb.add_option("--seed", words.seed, "who they are and all that is random, in place of the file's")
      ->check(CLI::Range(0, 1'000'000'000));
  verb.add_option("--trials", words.trials, "a CSV file of recorded trials in place of simulated operators");
  verb.add_option(
          "--repeat", words.experiments,
          "how many experiments, each with other people, in place of the file's; with --out they are kept "
          "as they are done, and the same call goes on")
      ->check(CLI::Range(1, 1'000'000));
  verb.add_option("--threads", call.models.threads, "how many threads; all cores without it");
}

Action declare_study(CLI::App& verb) {
  const auto call = std::make_shared<RunCall>();
  call->requires_section = "study";
  add_run_options(verb, *call,
                  "folder for trials.csv, errors.csv, tables.txt, study.json and all that run writes");
  add_study_options(verb, *call);
  return [call](const Registry& registry) { return run_models(*call, registry); };
}

}  // namespace

Verb study_verb() {
  return {"study", "run the trials of a human-subject study by simulated operators, and analyse them",
          "A file with a sweep makes the whole study at each of its points.\n\n"
          "Example:\n  stepwire study circle.yaml --subjects 20 --out out/circle",
          declare_study};
}

}  // namespace stepwire::cli
