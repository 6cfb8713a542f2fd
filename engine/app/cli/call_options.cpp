#include "engine/app/cli/call_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>

namespace stepwire {

namespace {

const std::map<std::string, Engine> engines = {
    {"interpreted", Engine::interpreted}, {"compiled", Engine::compiled}, {"auto", Engine::automatic}};

const CLI::Validator is_named([](const std::string& it) { return it.empty() ? "names no folder" : ""; }, "");

}  // namespace

void add_engine_option(CLI::App& verb, Engine& engine, const std::string& what) {
  const auto number_of = [](std::string& word) -> std::string {
    const auto known = engines.find(word);
    if (known == engines.end()) return fmt::format("must be auto, compiled or interpreted, not '{}'", word);
    word = std::to_string(static_cast<int>(known->second));
    return "";
  };
  CLI::Option* option = verb.add_option("--engine", engine, what);
  option->transform(CLI::Validator(number_of, "", "engine"))->option_text("ENGINE");
}

void add_loop_options(CLI::App& verb, LoopCommand& command) {
  LoopWords& words = command.words;
  verb.add_option("FILE", command.file, "a diagram file")->required();
  verb.add_option("--rate", words.rate, "how often the thread wakes [Hz]")->capture_default_str();
  verb.add_option("--duration", words.duration, "for how long [s]; the file's stop does not end it")
      ->capture_default_str();
  verb.add_option("--policy", words.policy, "how it is scheduled: fifo:1 to fifo:99, or other")
      ->capture_default_str();
  verb.add_option("--cpu", words.cpu, "the processor to which it is bound");
  verb.add_option("--overrun", words.overrun,
                  "what a missed deadline means: skip drops it, catch-up runs it late, stop:N ends the loop "
                  "after N in a row")
      ->capture_default_str();
  verb.add_option("--spin", words.spin, "time before each deadline at which it is awake, e.g. 200us")
      ->capture_default_str();
  add_engine_option(verb, command.engine,
                    "interpreted, or compiled before the loop begins; to the same bits");
  add_out_option(verb, "--out", command.out, "folder for signals.csv, inputs.csv, loop.json, loop.svg");
  verb.add_flag("--baseline", command.baseline, "measure cyclictest by turns, and set it beside the loop");
}

void add_fit_options(CLI::App& verb, FitWords& words) {
  verb.add_option("--follow", words.follow, "how many of the searches go on, in place of the file's")
      ->check(CLI::Range(1, 10'000));
  verb.add_option("--starts", words.starts, "how many searches, in place of the file's")
      ->check(CLI::Range(1, 10'000));
  verb.add_option("--seed", words.seed, "of random starts, in place of the file's");
  verb.add_option("--threads", words.threads, "how many threads; all cores without it");
}

void add_study_options(CLI::App& verb, RunCommand& command) {
  StudyWords& words = command.options.study;
  verb.add_option("--subjects", words.subjects, "how many people, in place of the file's")
      ->check(CLI::Range(1, 1000));
  verb.add_option("--seed", words.seed, "who they are and all that is random, in place of the file's")
      ->check(CLI::Range(0, 1'000'000'000));
  verb.add_option("--trials", words.trials, "a CSV file of recorded trials in place of simulated operators");
  verb.add_option(
          "--repeat", command.study_repeats,
          "how many experiments, each with other people; with --out, where they are kept and gone on with")
      ->check(CLI::Range(1, 1'000'000));
  verb.add_option("--threads", command.study_threads, "how many threads; all cores without it");
}

CLI::Option* add_out_option(CLI::App& verb, const std::string& names, std::string& out,
                            const std::string& what) {
  return verb.add_option(names, out, what)->check(is_named);
}

}  // namespace stepwire
