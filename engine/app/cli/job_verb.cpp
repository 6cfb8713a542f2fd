#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/model_call.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/session/session.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/model/diagram/part_file.hpp"

namespace stepwire::cli {
namespace {

struct JobCall {
  std::string file, out = "out", script;
  LoadWords words;
  bool slurm = false, pbs = false;
  std::size_t tasks = 0, threads = 1;
};

/// Syntax of a batch scheduler. Array tasks are numbered from 1.
struct Scheduler {
  const char *head, *task, *behind;
};
constexpr Scheduler slurm{
    "#SBATCH --job-name={}\n#SBATCH --ntasks=1\n#SBATCH --array=1-{}\n#SBATCH --cpus-per-task={}\n",
    "$SLURM_ARRAY_TASK_ID", "sbatch --dependency=afterany:JOB --wrap {}"};
constexpr Scheduler pbs{"#PBS -N {}\n#PBS -J 1-{}\n#PBS -l select=1:ncpus={}\n", "$PBS_ARRAY_INDEX",
                        "echo {} | qsub -W depend=afterany:JOB"};

/// Quotes a path for the shell, so that no program takes it for an option.
std::string path_word(const std::string& path) {
  return text::shell_word(path.starts_with('-') ? "./" + path : path);
}

/// Returns the load options of this call, for the command of each task.
std::string load_options_text(const LoadWords& words) {
  std::string text;
  for (const std::string& file : words.set_from) text += " --set-from " + path_word(file);
  for (const std::string& set : words.set) text += " --set " + text::shell_word(set);
  if (!words.stop.empty()) text += " --stop " + text::shell_word(words.stop);
  if (words.large) text += " --large";
  return text;
}

/// Returns the options for the folders of blocks and parts of this call.
std::string folder_options_text(const Registry& registry) {
  std::string text;
  for (const std::string& folder : registry.blocksets()) text += " --blocks " + path_word(folder);
  for (const std::string& folder : diagram::part_folders()) text += " --parts " + path_word(folder);
  return text;
}

/// Returns a job name that every scheduler accepts.
std::string job_name(const std::string& file) {
  std::string name = std::filesystem::path(file).stem().string();
  for (char& letter : name)
    if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '-';
  return "sw-" + name.substr(0, 12);
}

std::string script_of(const JobCall& call, const Registry& registry) {
  const Scheduler& scheduler = call.pbs ? pbs : slurm;
  const std::string here = text::shell_word(std::filesystem::current_path().string());
  const std::string program = text::shell_word(std::filesystem::read_symlink("/proc/self/exe").string());
  const std::string out = path_word(call.out);
  const std::string folders = folder_options_text(registry);
  const std::string collect =
      fmt::format("cd {} && {} collect {}/part-* --out {}/all{}", here, program, out, out, folders);
  std::string script = "#!/bin/sh\n" + fmt::format(fmt::runtime(scheduler.head), job_name(call.file),
                                                   call.tasks, call.threads);
  script +=
      "# Each task runs a share of the points of a sweep. One that was ended goes on when it is submitted "
      "again.\n";
  script += "# What joins the shares, for JOB the number that the scheduler has given this one:\n";
  script += fmt::format(
      "#   {}\n", text::visible(fmt::format(fmt::runtime(scheduler.behind), text::shell_word(collect))));
  script += fmt::format("cd {}\nexec {} run {} --part \"{}/{}\" --threads {} --out {}/\"part-{}\"{}{}\n",
                        here, program, path_word(call.file), scheduler.task, call.tasks, call.threads, out,
                        scheduler.task, load_options_text(call.words), folders);
  return script;
}

ExitCode write_job(const JobCall& call, const Registry& registry) {
  const session::LoadedModel model = session::Session(registry).load(call.file, load_options(call.words));
  const std::size_t points = model.job.points.size();
  const auto refuse = [&](const char* subject, yaml::Message message) {
    throw yaml::Error(yaml::Fault{{model.file, {}}, subject, std::move(message), {}});
  };
  if (points == 0 || model.study) refuse("", "has no section 'sweep', whose points tasks could share");
  if (call.tasks < 1 || call.tasks > points)
    refuse("--tasks",
           fmt::format("must be from 1 to {}, the points of the sweep, not {}", points, call.tasks));
  const std::string script = script_of(call, registry);
  if (call.script.empty())
    put_text(script);
  else
    io::write_file(call.script, script);
  return ExitCode::done;
}

Action declare_job(CLI::App& verb) {
  const auto call = std::make_shared<JobCall>();
  verb.add_option("FILE", call->file, "diagram file with a sweep")->required();
  auto* const of_slurm = verb.add_flag("--slurm", call->slurm, "for Slurm (sbatch), as without this option");
  verb.add_flag("--pbs", call->pbs, "for PBS (qsub)")->excludes(of_slurm);
  verb.add_option("--tasks", call->tasks, "how many tasks share the points")->required();
  verb.add_option("--out", call->out,
                  "folder of the shares, part-1 and so on, and of the results, all; else out");
  verb.add_option("--script", call->script, "file for the script; else it is printed");
  add_load_options(verb, call->words);
  verb.add_option("--stop", call->words.stop, "stop time in place of the file's: 2s");
  return [call](const Registry& registry) { return guarded([&] { return write_job(*call, registry); }); };
}

}  // namespace

Verb job_verb() {
  return {"job", "write the script by which a cluster runs a sweep",
          "Example:\n  stepwire job sweep.yaml --slurm --tasks 100 --script sweep.sh && sbatch sweep.sh",
          declare_job};
}

}  // namespace stepwire::cli
