#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/run_file.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/session/kept_points.hpp"
#include "engine/app/session/run_files.hpp"
#include "engine/simulate/replay/replay_folder.hpp"

namespace stepwire::cli {
namespace {

struct CollectCall {
  std::vector<std::string> folders;
  std::string out;
  std::optional<session::FileKinds> files;
  render::PictureKinds pictures = render::usual_pictures;
};

/// Journals in the given folders, which must be of the same sweep.
class Shares {
 public:
  Shares(const std::vector<std::string>& folders, const Registry& registry)
      : model_(session::load_kept(registry, folders.front())) {
    const std::string head = session::points_head(model_);
    for (const std::string& folder : folders) {
      const std::string path = session::points_path(folder);
      const auto own = journal::Journal::head_of(path);
      if (own != head) refuse(path, own.has_value(), folders.front());
      journals_.push_back(std::make_unique<journal::Journal>(path, head, model_.job, model_.kept.get(),
                                                             journal::Journal::Use::read));
    }
  }

  const session::LoadedModel& model() const { return model_; }
  std::vector<journal::Journal*> journals() const {
    std::vector<journal::Journal*> all;
    for (const auto& journal : journals_) all.push_back(journal.get());
    return all;
  }

 private:
  [[noreturn]] static void refuse(const std::string& path, bool is_journal, const std::string& first) {
    throw yaml::Error(yaml::Fault{
        {path, {}},
        "",
        is_journal ? yaml::Message("has points of another sweep than " + first)
                   : yaml::Message("is no file of points; 'run FILE --part K/N --out DIR' writes it"),
        {}});
  }

  session::LoadedModel model_;
  std::vector<std::unique_ptr<journal::Journal>> journals_;
};

ExitCode collect(const CollectCall& call, const Registry& registry) {
  const EndDelay delay(EndDelay::Signals::first);
  const Shares shares(call.folders, registry);
  const session::LoadedModel& model = shares.model();
  if (const std::string missing = session::missing_points(model, shares.journals()); !missing.empty()) {
    complain("{}: of {} points these are missing: {}; the same calls of 'run --part' go on with them\n",
             model.file, model.job.points.size(), missing);
    return ExitCode::surroundings;
  }
  const session::RowUse use{call.out, session::files_for(model, call.files)};
  session::require_rows(model, use);
  const auto owned = session::own_results(call.out, model, use.files);
  if (!call.out.empty()) replay::write_replay(call.out, model.job);
  const session::Outcome outcome = session::joined_points(model, shares.journals(), use);
  print_faults(outcome.result);
  if (!call.out.empty()) session::write_outputs(call.out, model, outcome, use.files, call.pictures);
  put_outcome(model, outcome);
  if (!call.out.empty()) say("  written to {}\n", call.out);
  return code_of(outcome);
}

Action declare_collect(CLI::App& verb) {
  const auto call = std::make_shared<CollectCall>();
  verb.add_option("DIR", call->folders, "folders of 'run --part', in any order")->required();
  verb.add_option("--out", call->out, "folder for the results of the whole sweep");
  add_kinds_options(verb, call->files, call->pictures);
  return [call](const Registry& registry) { return guarded([&] { return collect(*call, registry); }); };
}

}  // namespace

Verb collect_verb() {
  return {"collect", "join the shares of a sweep that 'run --part' has run",
          "Example:\n  stepwire run sweep.yaml --part 1/2 --out out/1 && stepwire run sweep.yaml --part 2/2 "
          "--out "
          "out/2\n  stepwire collect out/1 out/2 --out out/all",
          declare_collect};
}

}  // namespace stepwire::cli
