#include "engine/app/difference/revision.hpp"

#include <filesystem>

#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::difference {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& file, const std::string& problem) {
  throw yaml::Error(yaml::Fault{{file, {}}, "", problem, {}});
}

std::string without_line_end(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

std::string folder_of(const std::string& file) {
  const fs::path absolute = fs::absolute(file);
  return (fs::is_directory(absolute) ? absolute : absolute.parent_path()).string();
}

}  // namespace

std::string git_output(const std::string& folder, const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"git", "-C", folder};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const subprocess::ProcessResult result = subprocess::run_process({.command = command});
  if (!result.succeeded()) refuse(folder, result.problem("git"));
  return without_line_end(result.output);
}

/// Returns the hash of a revision. Throws yaml::Error for an unknown one.
static std::string commit_of(const std::string& top, const std::string& file, const std::string& revision) {
  try {
    return git_output(top, {"rev-parse", "--verify", "--quiet", "--end-of-options", revision + "^{commit}"});
  } catch (const yaml::Error&) {
    refuse(file, "its repository has no revision '" + revision + "'; git log lists them");
  }
}

Revision::Revision(const std::string& file, const std::string& revision)
    : revision_(revision), folder_(std::make_unique<subprocess::ScratchFolder>()) {
  const std::string top = git_output(folder_of(file), {"rev-parse", "--show-toplevel"});
  const std::string inside = fs::relative(fs::weakly_canonical(file), fs::weakly_canonical(top)).string();
  const std::string commit = commit_of(top, file, revision);
  const std::string archive = folder_->path() + "/all.tar", tree = folder_->path() + "/tree";
  git_output(top, {"archive", "--format=tar", "-o", archive, commit});
  io::require_folder(tree);
  subprocess::run_helper("tar", {.command = {"tar", "-xf", archive, "-C", tree}});
  file_ = (fs::path(tree) / inside).lexically_normal().string();
  if (!fs::exists(file_)) refuse(file, "is not in revision " + revision);
}

Revision::~Revision() = default;

std::string Revision::shown(const std::string& path) const {
  const std::string start = folder_->path() + "/tree/";
  return path.starts_with(start) ? revision_ + ":" + path.substr(start.size()) : path;
}

std::string line_difference(const std::string& path, const std::string& before, const std::string& after) {
  const subprocess::ScratchFolder folder;
  const std::string name = fs::path(path).filename().string();
  const std::string from = "a/" + name, to = "b/" + name;
  io::write_file(folder.path() + "/" + from, before);
  io::write_file(folder.path() + "/" + to, after);
  const subprocess::ProcessResult result =
      subprocess::run_process({.command = {"git", "-C", folder.path(), "diff", "--no-index", "--no-ext-diff",
                                           "--no-textconv", "--no-prefix", from, to}});
  return result.output;
}

bool is_diagram(const std::string& path, const std::string& text) {
  try {
    return yaml::parse_document(text, path).root.find("stepwire") != nullptr;
  } catch (const yaml::Error&) {
    return text.starts_with("stepwire:") || text.find("\nstepwire:") != std::string::npos;
  }
}

MergedLines merged_lines(const std::string& base, const std::string& ours, const std::string& theirs) {
  const subprocess::ScratchFolder folder;
  const std::string names[] = {folder.path() + "/ours", folder.path() + "/base", folder.path() + "/theirs"};
  io::write_file(names[0], ours);
  io::write_file(names[1], base);
  io::write_file(names[2], theirs);
  const subprocess::ProcessResult result =
      subprocess::run_process({.command = {"git", "merge-file", "-p", names[0], names[1], names[2]}});
  if (result.end != subprocess::ProcessResult::End::exited || result.status > 127)
    refuse("git merge-file", result.problem("git"));
  return {result.output, result.status == 0};
}

}  // namespace stepwire::difference
