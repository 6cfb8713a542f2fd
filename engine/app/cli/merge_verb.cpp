#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/difference/merge.hpp"
#include "engine/app/difference/revision.hpp"
#include "engine/app/language/text_places.hpp"
#include "engine/base/io/file.hpp"

namespace stepwire::cli {
namespace {

struct MergeCall {
  std::string base, ours, theirs;
  std::string path;  ///< of the file in its repository; empty: that of `ours`
  std::string out;   ///< empty: `ours`
};

/// Prints what is left to do in the written file. `path` is the name of the file in its faults.
void report(const std::string& written, const std::string& path, difference::Merged merged) {
  for (const difference::Conflict& one : merged.conflicts)
    complain("{}: {}: ours is {}, theirs is {}, before it was {}\n", written, one.at, one.ours, one.theirs,
             one.base);
  if (!merged.conflicts.empty())
    complain("{}: write the right values and remove the section 'conflicts' at its end\n", written);
  for (yaml::Fault& fault : merged.faults) {
    if (fault.place.file == path) fault.place.file = written;
    complain("{}\n", fault.text());
  }
  if (!merged.faults.empty())
    complain("{}: the merged diagram has these faults; mend them by hand\n", written);
}

/// Returns the text of a file. Throws yaml::Error for a missing one.
std::string text_of(const std::string& file) {
  if (!std::filesystem::is_regular_file(file))
    throw yaml::Error(yaml::Fault{{file, {}}, "", "is no file", {}});
  return io::read_file(file);
}

ExitCode merge(const MergeCall& call, const Registry& registry) {
  const std::string path = call.path.empty() ? call.ours : call.path;
  const std::string base = text_of(call.base), ours = text_of(call.ours), theirs = text_of(call.theirs);
  const std::string& out = call.out.empty() ? call.ours : call.out;
  if (!difference::is_diagram(path, ours) && !difference::is_diagram(path, theirs)) {
    const auto [text, is_clean] = difference::merged_lines(base, ours, theirs);
    io::write_file(out, text);
    return is_clean ? ExitCode::done : ExitCode::fails;
  }
  try {
    const difference::Merged merged = difference::merge(registry, path, base, ours, theirs);
    io::write_file(out, merged.text);
    report(call.out.empty() ? path : call.out, path, merged);
    return merged.is_clean() ? ExitCode::done : ExitCode::fails;
  } catch (const yaml::Error&) {
    for (const auto& [file, text] : {std::pair{&call.base, &base}, {&path, &ours}, {&call.theirs, &theirs}})
      yaml::parse_document(*text, *file);  // so that a fault names its file
    throw;
  } catch (const language::EditRefused& refusal) {
    complain("{}: {}\n", call.out.empty() ? path : call.out, refusal.what());
    return ExitCode::fails;
  }
}

Action declare_merge(CLI::App& verb) {
  const auto call = std::make_shared<MergeCall>();
  verb.add_option("BASE", call->base, "file of the common ancestor, %O of git")->required();
  verb.add_option("OURS", call->ours, "file of one side, %A of git; it gets the result")->required();
  verb.add_option("THEIRS", call->theirs, "file of the other side, %B of git")->required();
  verb.add_option("PATH", call->path, "path of the file, %P of git, beside which its parts are");
  verb.add_option("-o", call->out, "file to write in place of OURS");
  return [call](const Registry& registry) { return merge(*call, registry); };
}

}  // namespace

Verb merge_verb() {
  return {"merge", "merge two versions of a diagram by meaning",
          "Example:\n  stepwire merge base.yaml ours.yaml theirs.yaml -o merged.yaml\n"
          "The exit code is 0 if the result is right, 1 with conflicts or new faults, 2 if a file cannot be "
          "read.",
          declare_merge};
}

}  // namespace stepwire::cli
