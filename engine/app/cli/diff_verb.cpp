#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/kept_inputs.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/difference/difference_picture.hpp"
#include "engine/app/difference/difference_text.hpp"
#include "engine/app/difference/order.hpp"
#include "engine/app/difference/revision.hpp"
#include "engine/app/report/comparison_text.hpp"
#include "engine/app/session/fault_json.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/view/render/picture_kind.hpp"

namespace stepwire::cli {

using difference::Comparer;
using difference::Difference;
using difference::FactReader;
using difference::Texts;
using json::Json;

namespace {

namespace fs = std::filesystem;

// git calls an external diff with seven arguments, for a renamed file with nine, for an unmerged one with
// one.
constexpr std::size_t git_arguments = 7, git_arguments_of_rename = 9;

struct DiffCall {
  std::vector<std::string> files;
  std::string revision;  ///< "HEAD~1" or "v1..v2"; empty without one
  std::string out;       ///< picture to write; empty: none
  bool results = false;  ///< also run both, and compare the results
  bool json = false;
  bool facts = false;  ///< print the facts of one file
};

yaml::Error wrong_call(const std::string& text) {
  return yaml::Error(yaml::Fault{{"diff", {}}, "", text, {}});
}

/// Returns an error with other names of its files.
template <class Rename>
yaml::Error renamed(const yaml::Error& error, const Rename& rename) {
  std::vector<yaml::Fault> faults = error.faults();
  for (yaml::Fault& fault : faults) {
    rename(fault.place.file);
    for (yaml::Place& user : fault.used_by) rename(user.file);
  }
  return yaml::Error(std::move(faults));
}

/// Draws two files as one, into SVG or by the ending of the name into PNG or PDF.
void draw(const DiffCall& call, const Registry& registry, const std::string& from, const std::string& to,
          const Difference& found) {
  if (call.out.empty()) return;
  if (fs::is_directory(from) || fs::is_directory(to)) throw wrong_call("draws two files, not folders");
  const render::PictureKind kind = render::picture_kind_of(call.out);
  keep_inputs(call.out, std::vector{from, to});
  const std::string picture = difference::difference_picture(registry, from, to, found);
  io::write_file(call.out, render::converted(picture, kind));
}

using Results = std::optional<session::ResultComparison>;

/// Runs both files for a call with `results`; std::nullopt for others.
Results results_of(const DiffCall& call, const Registry& registry, const std::string& from,
                   const std::string& to) {
  if (!call.results) return std::nullopt;
  if (fs::is_directory(from) || fs::is_directory(to))
    throw wrong_call("runs two files with --results, not folders");
  session::Session session(registry);
  return session::compare_results(session, from, to);
}

/// Returns the diagram files of a folder by their path below it.
std::vector<std::string> diagrams_below(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path& path = entry.path();
    if (!entry.is_regular_file() || path.extension() != ".yaml") continue;
    const yaml::Document document = yaml::read_document(path.string());
    if (document.root.find("stepwire")) files.push_back(fs::relative(path, folder).string());
  }
  std::ranges::sort(files);
  return files;
}

/// Compares the files of two folders by name. A file that one of them lacks counts as empty.
void compare_folders(Comparer& comparer, Texts& before, Texts& after, const std::string& from,
                     const std::string& to) {
  std::vector<std::string> names = diagrams_below(from);
  for (const std::string& name : diagrams_below(to)) names.push_back(name);
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  for (const std::string& name : names) {
    const std::string old_file = (fs::path(from) / name).string(), new_file = (fs::path(to) / name).string();
    if (!fs::exists(old_file)) before.give(old_file, "");
    if (!fs::exists(new_file)) after.give(new_file, "");
    comparer.compare(old_file, new_file);
  }
}

/// Calls an action; the files in its errors get other names.
template <class Action, class Rename>
ExitCode guarded_with_names(const Action& action, const Rename& rename, Json* faults = nullptr) {
  return guarded(
      [&] {
        try {
          action();
        } catch (const yaml::Error& error) {
          throw renamed(error, rename);
        }
        return ExitCode::done;
      },
      faults);
}

/// Prints the differences, and those of the runs. A file that cannot run takes nothing away from the first.
template <class Rename>
ExitCode print(const DiffCall& call, const Registry& registry,
               const std::pair<std::string, std::string>& files, const Difference& shown,
               const Rename& rename) {
  if (!call.json) put_failure(difference::text_of(shown));
  Results results;
  Json faults;
  const ExitCode ran = guarded_with_names(
      [&] {
        results = results_of(call, registry, files.first, files.second);
        if (results) rename(results->signals.a), rename(results->signals.b);
      },
      rename, &faults);
  if (call.json) {
    Json all = result::json_of(shown);
    if (results) all.set("results", result::json_of(*results));
    if (faults.is_list()) all.set("faults", std::move(faults));
    put_json(all);
  } else if (results) {
    put_failure(report::results_text(*results));
  }
  const bool differs = !shown.is_empty() || (results && !results->agrees());
  return worst(ran, differs ? ExitCode::fails : ExitCode::done);
}

/// Prints the differences, and then draws them: a picture that fails takes nothing away. `shown` has the
/// names that `rename` gives to paths.
template <class Rename>
ExitCode print_and_draw(const DiffCall& call, const Registry& registry,
                        const std::pair<std::string, std::string>& files, const Difference& found,
                        const Difference& shown, const Rename& rename) {
  const ExitCode code = print(call, registry, files, shown, rename);
  const ExitCode drawn =
      guarded_with_names([&] { draw(call, registry, files.first, files.second, found); }, rename);
  return worst(code, drawn);
}

/// Throws Error for a file that holds a word or a list. A folder and an empty file are none of these.
void require_map(const std::string& file) {
  if (fs::is_directory(file)) return;
  const yaml::Document document = yaml::read_document(file);
  const yaml::Node& root = document.root;
  if (root.is_map() || (root.is_scalar() && root.text.empty())) return;
  throw yaml::Error(
      yaml::Fault{{file, root.mark}, "", "this is no diagram; a diagram is a map with blocks", {}});
}

Difference difference_of(const Registry& registry, const std::string& from, const std::string& to) {
  require_map(from);
  require_map(to);
  Texts before, after;
  Comparer comparer(registry, before, after);
  if (fs::is_directory(from) && fs::is_directory(to))
    compare_folders(comparer, before, after, from, to);
  else
    comparer.compare(from, to);
  return comparer.result();
}

ExitCode diff_revisions(const DiffCall& call, const Registry& registry) {
  const std::string& file = call.files.front();
  const std::string revision = call.revision.empty() ? "HEAD" : call.revision;
  const std::size_t dots = revision.find("..");
  const difference::Revision before(file, revision.substr(0, dots));
  std::optional<difference::Revision> after;
  if (dots != std::string::npos) after.emplace(file, revision.substr(dots + 2));
  const auto rename = [&](std::string& path) {
    path = before.shown(path);
    if (after) path = after->shown(path);
  };
  try {
    const std::string to = after ? after->file() : file;
    const Difference found = difference_of(registry, before.file(), to);
    Difference shown = found;
    for (difference::FileDifference& one : shown.files) rename(one.before), rename(one.after);
    return print_and_draw(call, registry, {before.file(), to}, found, shown, rename);
  } catch (const yaml::Error& error) {
    throw renamed(error, rename);
  }
}

/// Returns the text of a file that the call names. Throws TableError for an unreadable one.
std::string text_of_file(const std::string& file) try {
  return io::read_file(file);
} catch (const io::EnvironmentError& error) {
  throw table::TableError(error.what());
}

std::string text_of_side(const std::string& file) {
  return file == "/dev/null" ? "" : text_of_file(file);
}

/// Compares the two temporary files of git. Parts beside the path are those of the working tree, so they are
/// the same on both sides.
ExitCode diff_of_git(const DiffCall& call, const Registry& registry) {
  const std::string& path = call.files[0];
  const std::string after_path = call.files.size() == git_arguments_of_rename ? call.files[7] : path;
  const std::string old_text = text_of_side(call.files[1]), new_text = text_of_side(call.files[4]);
  if (!difference::is_diagram(path, old_text) && !difference::is_diagram(after_path, new_text)) {
    put_data(difference::line_difference(path, old_text, new_text));
    return ExitCode::done;
  }
  try {
    Texts before, after;
    before.give(path, old_text);
    after.give(after_path, new_text);
    Comparer comparer(registry, before, after);
    comparer.compare(path, after_path, false);
    put_failure(difference::text_of(comparer.result()));
  } catch (const yaml::Error& error) {
    complain("{}\n", error.what());
    put_data(difference::line_difference(path, old_text, new_text));
  }
  return ExitCode::done;  // git takes any other code for a crash
}

ExitCode print_facts(const std::string& file, const Registry& registry) {
  const std::string text = text_of_file(file);
  try {
    if (!difference::is_diagram(file, text)) throw wrong_call("is no diagram");
    Texts texts;
    FactReader reader(registry, texts);
    const difference::FileFacts facts = reader.read(file);
    put_data(difference::facts_text(facts.root) +
             difference::orders_text(difference::orders_of(facts.source->document.root)));
  } catch (const yaml::Error&) {
    put_data(text);
  }
  return ExitCode::done;
}

ExitCode diff(const DiffCall& call, const Registry& registry) {
  const std::size_t count = call.files.size();
  if (call.facts) return print_facts(call.files.front(), registry);
  if (count == git_arguments || count == git_arguments_of_rename) return diff_of_git(call, registry);
  if (count == 1) return diff_revisions(call, registry);
  if (count != 2) throw wrong_call(fmt::format("takes one or two files, not {}", count));
  if (!call.revision.empty()) throw wrong_call("takes one file with --rev");
  const Difference found = difference_of(registry, call.files[0], call.files[1]);
  return print_and_draw(call, registry, {call.files[0], call.files[1]}, found, found, [](std::string&) {});
}

Action declare_diff(CLI::App& verb) {
  const auto call = std::make_shared<DiffCall>();
  verb.add_option("FILES", call->files,
                  "two diagram files or folders; one file is compared with its last commit")
      ->required();
  verb.add_option("--rev", call->revision, "revision of git to compare with, HEAD~1, or two, v1..v2");
  verb.add_option("-o,--out", call->out, "one drawing of both to write: SVG, or PNG or PDF by its ending")
      ->type_name("FILE");
  verb.add_flag("--results", call->results,
                "also run both; worst difference of each signal, claims with another verdict");
  verb.add_flag("--json", call->json, "print the differences as JSON");
  verb.add_flag("--text", call->facts, "print the meaning of one file in sorted lines, for git log -p");
  return [call](const Registry& registry) {
    Json faults;
    const ExitCode code = guarded([&] { return diff(*call, registry); }, &faults);
    if (call->json && faults.is_list()) put_json(Json::object().set("faults", std::move(faults)));
    return code;
  };
}

}  // namespace

Verb diff_verb() {
  return {"diff", "compare the meaning of two diagrams, or of two revisions of one",
          "Example:\n  stepwire diff rig.yaml --rev HEAD~1\n"
          "The exit code is 0 if both mean the same, 1 if they differ, 2 if a file cannot be read, 3 without "
          "the picture.\n"
          "Order, comments, layout and notation of numbers make no difference.",
          declare_diff};
}

}  // namespace stepwire::cli
