#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/model_call.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/cli/watch.hpp"
#include "engine/app/report/run_text.hpp"
#include "engine/base/data_file/reading_log.hpp"
#include "engine/base/text/count.hpp"
#include "engine/model/diagram/unread.hpp"

namespace stepwire::cli {

using json::Json;

namespace {

/// Returns a list of the conversions that were applied when data files were read.
Json files_json() {
  Json all = Json::list();
  for (const data_file::FileReading& file : data_file::ReadingLog::files())
    all.push(Json::object().set("file", file.file).set("done", Json::list_of(file.done)));
  return all;
}

void say_files() {
  for (const data_file::FileReading& file : data_file::ReadingLog::files())
    if (!file.done.empty()) say("  {}: {}\n", file.file, fmt::join(file.done, ", "));
}

ExitCode check(const session::LoadedModel& model, const ModelCall& call, Json& results) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  if (call.json) {
    results.push(Json::object()
                     .set("file", model.file)
                     .set("blocks", diagram.blocks.size())
                     .set("claims", model.claims.size())
                     .set("figures", model.figures.size())
                     .set("data_files", files_json()));
    return ExitCode::done;
  }
  print_notes(model);
  if (call.units) put_text(report::units_text(model.job.plan));
  const std::size_t notes = call.strict ? diagram::unread_blocks(diagram).size() : 0;
  say("{}: {}, {}, {}: {}\n", model.file, text::counted(diagram.blocks.size(), "block"),
      text::counted(model.claims.size(), "claim"), text::counted(model.figures.size(), "figure"),
      notes > 0 ? text::counted(notes, "note") : "nothing wrong");
  say_files();
  return ExitCode::done;
}

/// Checks one file in a round of --watch. Faults are printed on the standard error.
void check_again(const std::string& file, const ModelCall& call, const Registry& registry,
                 WatchedFiles& watched) {
  diagram::Loader loader(registry,
                         call.words.large ? load_options(call.words).limits : yaml::DocumentLimits{});
  watched.add(file);
  Json none;
  const data_file::ReadingLog log;
  const ExitCode code = guarded([&] {
    const session::LoadedModel model = session::load_model(loader, file, load_options(call.words));
    watched.add(model.job.plan.diagram);
    say("{} ", time_of_day());
    return check(model, call, none);
  });
  watched.add(loader);
  if (code != ExitCode::done) say("{} {}: not right\n", time_of_day(), file);
}

Action declare_check(CLI::App& verb) {
  const auto call = std::make_shared<ModelCall>();
  const auto again = std::make_shared<bool>(false);
  add_model_options(verb, *call);
  verb.add_flag("--watch", *again, "check again when a file changes, until Ctrl-C")->excludes("--json");
  return [call, again](const Registry& registry) {
    if (*again)
      return watch([&](WatchedFiles& watched) {
        for (const std::string& file : call->files)
          if (!interrupted()) check_again(file, *call, registry, watched);
      });
    return each_model(*call, registry, [&](const session::LoadedModel& model, Json& results) {
      return check(model, *call, results);
    });
  };
}

}  // namespace

Verb check_verb() {
  return {"check", "do all that run does before the first step",
          "Example:\n  stepwire check diagrams/examples/*.yaml", declare_check};
}

}  // namespace stepwire::cli
