#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/kept_inputs.hpp"
#include "engine/app/cli/model_call.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/base/io/file.hpp"
#include "engine/model/diagram/flatten.hpp"
#include "engine/simulate/replay/replay_folder.hpp"

namespace stepwire::cli {
namespace {

struct FlattenCall {
  std::string file;
  LoadWords words;
  std::string out;  ///< file; empty: standard output
};

ExitCode flatten(const FlattenCall& call, const Registry& registry) {
  const session::LoadOptions options = load_options(call.words);
  diagram::Loader loader(registry, options.limits);
  const plan::Plan plan = plan::make_plan(loader.load(call.file, options.settings));
  keep_inputs(call.out, replay::files_read(plan));
  const std::string text = diagram::flattened_text(plan.diagram);
  if (call.out.empty())
    put_data(text);
  else
    io::write_file(call.out, text);
  return ExitCode::done;
}

Action declare_flatten(CLI::App& verb) {
  const auto call = std::make_shared<FlattenCall>();
  verb.add_option("FILE", call->file, "a diagram file")->required();
  add_load_options(verb, call->words);
  verb.add_option("-o", call->out, "file to write; standard output without it");
  return [call](const Registry& registry) { return flatten(*call, registry); };
}

}  // namespace

Verb flatten_verb() {
  return {"flatten", "write a diagram as one file, without parts and parameters",
          "Example:\n  stepwire flatten rig.yaml --set rig.mass=2kg -o flat.yaml", declare_flatten};
}

}  // namespace stepwire::cli
