#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/app/cli/commands.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/output.hpp"
#include "engine/app/cli/profile_report.hpp"
#include "engine/app/cli/progress.hpp"
#include "engine/app/cli/report.hpp"
#include "engine/app/cli/studying.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/view/render/figure_file.hpp"

namespace stepwire {

namespace {

/// Several files get a folder each.
std::string folder_of(const RunCommand& command, const std::string& file) {
  if (command.files.size() == 1) return command.out;
  return (std::filesystem::path(command.out) / std::filesystem::path(file).stem()).string();
}

/// Files of one name in different folders would write over each other.
bool folders_differ(const RunCommand& command) {
  std::map<std::string, std::string> files;
  for (const std::string& file : command.files) {
    const auto [first, is_new] = files.emplace(folder_of(command, file), file);
    if (is_new || command.out.empty()) continue;
    complain("{} and {} would both be written to {}; give each a call with its own --out\n", first->second,
             file, first->first);
    return false;
  }
  return true;
}

ExitCode check(const Work& work, const RunCommand& command, Json& results) {
  const Diagram& diagram = work.job.plan.diagram;
  if (command.json) {
    Json result = Json::object()
                      .set("file", work.file)
                      .set("blocks", diagram.blocks.size())
                      .set("claims", work.claims.size());
    results.push(result.set("figures", work.figures.size()));
    return ExitCode::done;
  }
  if (command.units) put_text(units_text(diagram));
  say("{}: {} blocks, {} claims, {} figures: nothing wrong\n", work.file, diagram.blocks.size(),
      work.claims.size(), work.figures.size());
  return ExitCode::done;
}

/// Says once why nothing is compiled.
void tell_problem(GeneratedCode& code) {
  const std::string problem = code.take_problem();
  if (!problem.empty()) complain("interpreted, since {}\n", problem);
}

Outcome carry_out_visibly(const Work& work, Engine engine, GeneratedCode& code) {
  RunOptions options;
  options.interrupt = &interrupted();
  options.engine = engine;
  options.code = &code;
  Outcome outcome;
  {
    Progress progress(std::filesystem::path(work.file).filename().string());
    options.progress = [&](double fraction) { progress.show(fraction); };
    outcome = carry_out(work, options);
  }
  tell_problem(code);
  return outcome;
}

/// Measured behind the run, on a run of its own: what is recorded and judged is that of any other call.
std::optional<Profile> wanted_profile(const Work& work, const RunCommand& command) {
  if (!command.profile || interrupted()) return std::nullopt;
  return profile_of(work);
}

void write_profile(const std::string& folder, const Work& work, const Profile& profile) {
  write_file(folder + "/profile.csv", profile_csv(profile));
  write_figure(folder, "profile", profile_figure(work, profile));
}

/// Finds the parameters for which the file asks, tells them, and puts them into the work.
ExitCode fit_first(Work& work, const RunCommand& command, const Registry& registry, GeneratedCode& code,
                   Json& results) {
  if (!work.fit && command.fit_asked)
    throw Error(
        Fault{{work.file, {}}, "", "asks for no fit; a section 'fit' names parameters and records", {}});
  if (!work.fit) return ExitCode::done;
  const bool compiles =
      command.engine == Engine::compiled || (command.engine == Engine::automatic && worth_compiling(work));
  const FitResult result =
      fit_visibly(registry, work, command.options, command.fit, compiles ? &code : nullptr);
  tell_problem(code);
  if (!command.out.empty()) write_fit(folder_of(command, work.file), work, result);
  if (command.json)
    results.push(Json::object().set("fit", fit_json(work, result)));
  else
    put_text(fit_text(result));
  if (code_of(result) == ExitCode::done)
    work = prepare(registry, work.file, with_fitted(command.options, result));
  return code_of(result);
}

/// Makes the study for which the file asks, in the place of a run.
ExitCode study(Work& work, const RunCommand& command, const Registry& registry, Studies& studies,
               Json& results) {
  const std::string folder = command.out.empty() ? "" : folder_of(command, work.file);
  const StudyCall call{command.engine, command.study_threads, true};
  if (command.study_repeats > 0)
    return repeat_study(registry, work, command.options, call, command.study_repeats, folder);
  const auto experiments = studies.experiments(registry, work, command.options, call);
  const Outcome outcome = carry_out_study(work, *experiments);
  if (outcome.result.interrupted) return ExitCode::interrupted;  // nothing is kept of half a study
  if (!folder.empty()) {
    write_outputs(folder, work, outcome);
    write_study(folder, work, *experiments, outcome);
  }
  if (command.json) {
    Json result = run_json(work, outcome).set("claims", claims_json(work, outcome));
    results.push(result.set("study", study_json(work, *experiments)));
    return outcome.code;
  }
  say("{}{}", study_text(work, *experiments), outcome_text(work, outcome));
  if (!folder.empty()) say("  written to {}\n", folder);
  return outcome.code;
}

void require_study(const Work& work, const RunCommand& command) {
  if (command.study_asked && !work.study)
    throw Error(Fault{
        {work.file, {}}, "", "asks for no study; a section 'study' names task, people and conditions", {}});
}

/// The folder of a file's results, from now on this run's alone. What the file itself reads may lie there,
/// and experiments that took hours stay for the call that goes on with them.
std::optional<OwnedFolder> own_folder(const RunCommand& command, const Work& work) {
  if (command.out.empty()) return std::nullopt;
  const std::string folder = folder_of(command, work.file);
  return std::optional<OwnedFolder>(std::in_place, folder, [&] {
    std::set<std::string> files = files_read(work.job);
    files.insert({folder + "/experiments.csv", folder + "/experiments.json"});
    if (work.study && !work.study->trials.empty()) files.insert(work.study->trials);
    return files;
  });
}

/// Throws where the folder holds files of these names that no run wrote: before the run, not behind it.
void reserve_results(const std::string& folder) {
  for (const char* name : {"signals.csv", "signals.mat", "claims.json", "run.json"})
    note_written(folder + "/" + name);
}

ExitCode run(const Work& work, const RunCommand& command, GeneratedCode& code, Json& results) {
  const std::string folder = command.out.empty() ? "" : folder_of(command, work.file);
  // Better now than after an hour, in which data files may change.
  if (!folder.empty()) write_replay(folder, work.job);
  const Outcome outcome = carry_out_visibly(work, command.engine, code);
  print_faults(outcome.result);
  if (!folder.empty()) write_outputs(folder, work, outcome);
  const std::optional<Profile> profile = wanted_profile(work, command);
  if (profile && !folder.empty()) write_profile(folder, work, *profile);
  if (command.json) {
    Json result = run_json(work, outcome).set("claims", claims_json(work, outcome));
    if (profile) result.set("profile", profile_json(*profile));
    results.push(std::move(result));
    return outcome.code;
  }
  if (command.units) put_text(units_text(work.job.plan.diagram));
  put_text(outcome_text(work, outcome));
  if (profile) put_text(profile_text(work, *profile));
  if (!folder.empty()) say("  written to {}\n", folder);
  return outcome.code;
}

}  // namespace

ExitCode run_files(const RunCommand& command, const Registry& registry) {
  if (!folders_differ(command)) return ExitCode::wrong;
  ExitCode code = ExitCode::done;
  GeneratedCode compiler;
  Studies studies;
  Json results = Json::list();
  for (const std::string& file : command.files) {
    if (interrupted()) break;
    code = worst(code, guarded([&] {
                   Work work = prepare(registry, file, command.options);
                   if (command.check_only) return check(work, command, results);
                   require_study(work, command);
                   const EndDelay delay(EndDelay::Signals::first);
                   const auto folder = own_folder(command, work);
                   if (folder) reserve_results(folder_of(command, file));
                   if (work.study) return study(work, command, registry, studies, results);
                   const ExitCode fitted = fit_first(work, command, registry, compiler, results);
                   return fitted == ExitCode::done ? run(work, command, compiler, results) : fitted;
                 }));
  }
  if (command.json) say("{}\n", results.text());
  return interrupted() ? ExitCode::interrupted : code;
}

}  // namespace stepwire
