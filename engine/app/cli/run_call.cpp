#include "engine/app/cli/run_call.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "engine/app/cli/call_options.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/guarded.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/monitoring.hpp"
#include "engine/app/report/fit_text.hpp"
#include "engine/app/report/profile_report.hpp"
#include "engine/app/report/run_text.hpp"
#include "engine/app/report/study_text.hpp"
#include "engine/app/report/tune_text.hpp"
#include "engine/app/session/result_folder.hpp"
#include "engine/app/session/run_files.hpp"
#include "engine/app/session/session.hpp"
#include "engine/base/io/file.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/view/render/figure_file.hpp"

namespace stepwire::cli {

using json::Json;

namespace {

/// Several files get a folder each; empty where nothing is written.
std::string folder_of(const RunCall& call, const std::string& file) {
  if (call.models.files.size() == 1 || call.out.empty()) return call.out;
  return (std::filesystem::path(call.out) / std::filesystem::path(file).stem()).string();
}

/// Files of one name in different folders would write over each other.
bool folders_differ(const RunCall& call) {
  std::map<std::string, std::string> files;
  for (const std::string& file : call.models.files) {
    const auto [first, is_new] = files.emplace(folder_of(call, file), file);
    if (is_new || call.out.empty()) continue;
    complain("{} and {} would both be written to {}; give each a call with its own --out\n", first->second,
             file, first->first);
    return false;
  }
  return true;
}

void require_section(const RunCall& call, const session::LoadedModel& model) {
  const auto refuse = [&](const char* message) {
    throw yaml::Error(yaml::Fault{{model.file, {}}, "", message, {}});
  };
  if (call.requires_section == "fit" && !model.fit)
    refuse("has no section 'fit'; it names parameters and records");
  if (call.requires_section == "tune" && !model.tune)
    refuse("has no section 'tune'; it names parameters and what is minimised");
  if (call.requires_section == "study" && !model.study)
    refuse("has no section 'study'; it names task, people and conditions");
}

std::string file_name(const session::LoadedModel& model) {
  return std::filesystem::path(model.file).filename().string();
}

/// What the files of one call share, and what is done with each of them.
class FileRuns {
 public:
  FileRuns(const RunCall& call, const Registry& registry) : call_(call), session_(registry) {}

  ExitCode carry_out(session::LoadedModel& model, Json& results) {
    require_section(call_, model);
    const EndDelay delay(EndDelay::Signals::first);
    const std::string folder = folder_of(call_, model.file);
    const auto owned = session::own_results(folder, model, call_.files);
    if (model.study) return study(model, folder, results);
    const ExitCode fitted = model.fit ? fit(model, folder, results) : ExitCode::done;
    if (fitted != ExitCode::done) return fitted;
    const bool tunes = call_.requires_section == "tune";
    const ExitCode tuned = tunes ? tune(model, folder, results) : ExitCode::done;
    return tuned == ExitCode::done ? run(model, folder, results) : tuned;
  }

 private:
  /// Finds the parameters of the section `fit`, prints them, and loads the model with them.
  ExitCode fit(session::LoadedModel& model, const std::string& folder, Json& results) {
    session::FitCall call = call_.fit;
    call.engine = call_.engine;
    const estimation::FitResult result = [&] {
      const auto watch = watched("fit " + file_name(model));
      return session_.fit(model, call);
    }();
    if (!folder.empty() && !result.records.empty()) session::write_fit(folder, model, result);
    if (call_.models.json)
      results.push(Json::object().set("fit", session::fit_json(model, result)));
    else
      put_text(report::fit_text(result));
    const ExitCode code = code_of(result);
    if (code == ExitCode::done) model = session_.fitted(model, result);
    return code;
  }

  /// Finds the parameters of the section `tune`, prints them, and loads the model with them.
  ExitCode tune(session::LoadedModel& model, const std::string& folder, Json& results) {
    session::TuneCall call = call_.tune;
    call.engine = call_.engine;
    const tuning::TuneResult result = [&] {
      const auto watch = watched("tune " + file_name(model));
      return session_.tune(model, call);
    }();
    if (!folder.empty() && !result.history.empty()) session::write_tune(folder, model, result);
    if (call_.models.json)
      results.push(Json::object().set("tune", session::tune_json(model, result)));
    else
      put_text(report::tune_text(result));
    const ExitCode code = code_of(result);
    if (code == ExitCode::done) model = session_.tuned(model, result);
    return code;
  }

  ExitCode run(const session::LoadedModel& model, const std::string& folder, Json& results) {
    // Better now than after an hour, in which data files may change.
    if (!folder.empty()) replay::write_replay(folder, model.job);
    const session::Outcome outcome = [&] {
      const auto watch = watched(file_name(model));
      return session_.run(model, call_.engine);
    }();
    print_faults(outcome.result);
    if (!folder.empty()) session::write_outputs(folder, model, outcome, call_.files);
    const std::optional<profile::Profile> profile = wanted_profile(model);
    if (profile && !folder.empty()) write_profile(folder, model, *profile);
    if (call_.models.json) {
      Json result = session::run_json(model, outcome).set("claims", session::claims_json(model, outcome));
      if (profile) result.set("profile", report::profile_json(*profile));
      results.push(std::move(result));
      return code_of(outcome);
    }
    if (call_.models.units) put_text(report::units_text(model.job.plan));
    put_text(report::outcome_text(model, outcome));
    if (profile) put_text(report::profile_text(model, *profile));
    if (!folder.empty()) say("  written to {}\n", folder);
    return code_of(outcome);
  }

  /// A bar on the terminal for what the session does from now on, as long as it lives.
  std::unique_ptr<Progress> watched(const std::string& label) {
    auto progress = std::make_unique<Progress>(label);
    session_.monitor() = terminal_monitor(progress.get());
    return progress;
  }

  /// Measured behind the run, on a run of its own: what is recorded and judged is that of any other call.
  std::optional<profile::Profile> wanted_profile(const session::LoadedModel& model) const {
    if (!call_.profile || interrupted()) return std::nullopt;
    return report::profile_of(model, &interrupted());
  }

  static void write_profile(const std::string& folder, const session::LoadedModel& model,
                            const profile::Profile& profile) {
    io::write_file(folder + "/profile.csv", report::profile_csv(profile));
    render::write_figure(folder, "profile", report::profile_figure(model, profile));
  }

  /// Makes the study of the section `study`, in the place of a run.
  ExitCode study(session::LoadedModel& model, const std::string& folder, Json& results) {
    const auto experiments = [&] {
      const auto watch = watched("study " + file_name(model));
      return session_.study(model, {call_.engine, call_.study_threads, folder});
    }();
    const session::Outcome outcome = session::study_outcome(model, *experiments);
    if (outcome.result.interrupted) {  // nothing is kept of half an experiment
      if (!folder.empty() && model.study->experiments > 1)
        say("the experiments that are done are kept in {}; the same call goes on\n", folder);
      return ExitCode::interrupted;
    }
    if (!folder.empty()) {
      session::write_outputs(folder, model, outcome, call_.files);
      session::write_study(folder, model, *experiments, outcome);
    }
    if (call_.models.json) {
      Json result = session::run_json(model, outcome).set("claims", session::claims_json(model, outcome));
      results.push(result.set("study", session::study_json(model, *experiments)));
      return code_of(outcome);
    }
    say("{}{}", report::study_text(model, *experiments), report::outcome_text(model, outcome));
    if (!folder.empty()) say("  written to {}\n", folder);
    return code_of(outcome);
  }

  const RunCall& call_;
  session::Session session_;
};

}  // namespace

/// A list of words, each once.
static session::FileKinds files_of(const std::string& list) {
  session::FileKinds kinds;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    const std::string word = list.substr(at, end - at);
    const auto kind = session::file_kind(word);
    if (!kind)
      throw CLI::ValidationError("--files", fmt::format("takes of {}, not '{}'; several are separated by commas",
                                                        session::file_kind_names(), word));
    if (std::ranges::find(kinds, *kind) == kinds.end()) kinds.push_back(*kind);
    at = end + 1;
  }
  return kinds;
}

static void add_files_option(CLI::App& verb, RunCall& call) {
  verb.add_option_function<std::string>(
          "--files", [&call](const std::string& list) { call.files = files_of(list); },
          fmt::format("kinds of files for the recorded signals in --out, of {}; left out: csv,mat",
                      session::file_kind_names()))
      ->option_text("KIND,...");
}

void add_run_options(CLI::App& verb, RunCall& call, const std::string& out) {
  add_model_options(verb, call.models);
  add_engine_option(verb, call.engine,
                    "interpreted, compiled, or auto: compiled once that is worth it; all to the same bits");
  verb.add_option("--out", call.out, out);
  add_files_option(verb, call);
}

ExitCode run_models(const RunCall& call, const Registry& registry) {
  if (!folders_differ(call)) return ExitCode::wrong;
  FileRuns runs(call, registry);
  return each_model(call.models, registry, [&](session::LoadedModel& model, Json& results) {
    if (!call.models.json) print_notes(model);
    return runs.carry_out(model, results);
  });
}

}  // namespace stepwire::cli
