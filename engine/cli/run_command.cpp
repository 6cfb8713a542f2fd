#include <fmt/format.h>

#include <filesystem>

#include "engine/cli/commands.hpp"
#include "engine/cli/interrupt.hpp"
#include "engine/cli/output.hpp"
#include "engine/cli/progress.hpp"
#include "engine/cli/report.hpp"

namespace stepwire {

namespace {

/// Several files get a folder each.
std::string folder_of(const RunCommand& command, const std::string& file) {
  if (command.files.size() == 1) return command.out;
  return (std::filesystem::path(command.out) / std::filesystem::path(file).stem()).string();
}

ExitCode check(const Work& work, const RunCommand& command) {
  const Diagram& diagram = work.job.plan.diagram;
  if (command.units) fmt::print("{}", units_text(diagram));
  if (!command.json)
    fmt::print("{}: {} blocks, {} claims, {} figures: nothing wrong\n", work.file, diagram.blocks.size(), work.claims.size(),
               work.figures.size());
  return ExitCode::done;
}

ExitCode run(const Work& work, const RunCommand& command, Json& results) {
  Outcome outcome;
  {
    Progress progress(std::filesystem::path(work.file).filename().string());
    RunOptions options;
    options.interrupt = &interrupted();
    options.progress = [&](double fraction) { progress.show(fraction); };
    outcome = carry_out(work, options);
  }
  for (const RunFault& fault : outcome.result.faults) fmt::print(stderr, "{}\n", fault.fault.text());
  if (command.units) fmt::print("{}", units_text(work.job.plan.diagram));
  if (command.json) {
    results.push(run_json(work, outcome).set("claims", claims_json(work, outcome)));
  } else {
    fmt::print("{}", outcome_text(work, outcome));
  }
  if (command.out.empty()) return outcome.code;
  const std::string folder = folder_of(command, work.file);
  write_outputs(folder, work, outcome);
  if (!command.json) fmt::print("  written to {}\n", folder);
  return outcome.code;
}

}  // namespace

ExitCode run_files(const RunCommand& command, const Registry& registry) {
  ExitCode code = ExitCode::done;
  Json results = Json::list();
  for (const std::string& file : command.files) {
    if (interrupted()) break;
    code = worst(code, guarded([&] {
                   const Work work = prepare(registry, file, command.options);
                   return command.check_only ? check(work, command) : run(work, command, results);
                 }));
  }
  if (command.json) fmt::print("{}\n", results.text());
  return interrupted() ? ExitCode::interrupted : code;
}

}  // namespace stepwire
