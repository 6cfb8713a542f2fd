#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/app/cli/exit_code.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/base/json/json.hpp"

namespace CLI {
class App;
}

namespace stepwire::cli {

/// Options for loading diagram files: --set, --set-from, --large, and --stop of some verbs.
struct LoadWords {
  std::vector<std::string> set;
  std::vector<std::string> set_from;
  std::string stop;
  bool large = false;
};

/// Declares all options but --stop.
void add_load_options(CLI::App& verb, LoadWords& words);

/// Converts the words to load options. Settings of files precede those of the call, which therefore win.
/// Throws Error for a setting that is not "name=value" and for a file that is no flat map of values;
/// EnvironmentError for an unreadable file.
session::LoadOptions load_options(const LoadWords& words);

/// Call of a verb for several diagram files.
struct ModelCall {
  std::vector<std::string> files;
  LoadWords words;
  study::StudyWords study;  ///< replace values of the section `study`
  unsigned threads = 0;     ///< Threads for several runs of a file; 0: all cores.
  bool units = false;
  bool json = false;
  bool strict = false;  ///< A note makes the exit code that of a failed claim.
  /// Called with each file that could not be loaded or run, and the reason.
  std::function<void(const std::string& file, const std::string& fault)> refused{};

  /// Returns the exit code of an action with or without a note.
  ExitCode code_of_notes(bool any) const { return strict && any ? ExitCode::fails : ExitCode::done; }
};

/// Declares FILE..., --set, --set-from, --large, --stop, --units, --json, --strict.
void add_model_options(CLI::App& verb, ModelCall& call);

/// Action on one loaded file. Results for --json are pushed to the list.
using ModelAction = std::function<ExitCode(session::LoadedModel& model, json::Json& results)>;

/// Loads the files one after the other and performs the action on each, until interrupted. Faults of a file
/// end only its own action. They are printed, and with --json they are in the results as {file, faults}.
ExitCode each_model(const ModelCall& call, const Registry& registry, const ModelAction& action);

/// Prints notes on suspicious parts of a diagram, such as unread blocks, on the standard error.
void print_notes(const session::LoadedModel& model);

}  // namespace stepwire::cli
