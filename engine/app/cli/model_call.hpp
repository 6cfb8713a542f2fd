#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/load_words.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::cli {

/// A call of a verb for several diagram files.
struct ModelCall {
  std::vector<std::string> files;
  LoadWords words;
  study::StudyWords study;  ///< in place of what a section `study` has
  unsigned threads = 0;     ///< for what is done with a file, in so far as it has several runs; 0: all cores
  bool units = false;
  bool json = false;
};

/// Declares FILE..., --set, --set-from, --large, --stop, --units, --json.
void add_model_options(CLI::App& verb, ModelCall& call);

/// What is done with one file; results for programs are pushed to the list.
using ModelAction = std::function<ExitCode(session::LoadedModel& model, json::Json& results)>;

/// Loads one file after the other and does that with it, until interrupted. What is wrong with a file ends
/// its own turn: it is printed, and with --json it stands in the results as {file, faults}.
ExitCode each_model(const ModelCall& call, const Registry& registry, const ModelAction& action);

/// What is no fault and may yet be none of what was meant, on the standard error.
void print_notes(const session::LoadedModel& model);

}  // namespace stepwire::cli
