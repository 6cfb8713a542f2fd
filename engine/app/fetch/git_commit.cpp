// The files of a commit, through git's own commands.
// Problem: addresses, commits and trees are written by others. An address can name a program that git runs, a
// tree can have names such as "..", and links can lead anywhere.
// Idea: git is called with lists of arguments, never through a shell, and may only use https, ssh and files.
// A bare repository in a temporary folder takes the commit. `ls-tree` and `cat-file` give names and bytes,
// each name is checked, and links are made last. So no hook, filter or attribute of the repository acts.
#include "engine/app/fetch/git_commit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>
#include <sstream>
#include <string_view>

#include "engine/base/io/file.hpp"
#include "engine/base/io/inside.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::fetch {
namespace {

namespace fs = std::filesystem;
using subprocess::ProcessResult;

/// A file, link or submodule of a commit.
struct TreeEntry {
  std::string mode, object, path;

  bool is_link() const { return mode == "120000"; }
  bool is_submodule() const { return mode == "160000"; }
};

ProcessResult git(std::vector<std::string> arguments, std::string input = "") {
  arguments.insert(arguments.begin(), "git");
  return subprocess::run_process(
      {.command = std::move(arguments),
       .input = std::move(input),
       .variables = {"GIT_ALLOW_PROTOCOL=https:ssh:file", "GIT_TERMINAL_PROMPT=0", "LC_ALL=C"},
       .limit = std::chrono::minutes(10)});
}

/// Returns the last line of git's error message, which has the reason.
std::string reason_of(const ProcessResult& result) {
  std::istringstream lines(result.errors);
  std::string reason;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("fatal: ") || line.starts_with("error: "))
      if (reason.empty()) reason = line.substr(7);
  return text::visible(reason.empty() ? result.problem("git") : reason);
}

std::string checked(const ProcessResult& result, const std::string& what) {
  if (result.succeeded()) return result.output;
  throw FetchProblem(fmt::format("{} ({})", what, reason_of(result)));
}

/// Temporary repository that takes one commit of another.
class Repository {
 public:
  Repository(const std::string& url, const std::string& commit) {
    if (folder_.path().empty()) throw io::EnvironmentError("no temporary folder can be made");
    checked(call({"init", "-q", "--bare"}), "git cannot make a repository");
    take(url, commit);
    refuse_tag(commit);
  }

  std::vector<TreeEntry> entries(const std::string& commit) const {
    std::istringstream list(checked(call({"ls-tree", "-r", "-z", "--full-tree", commit}), "no files"));
    std::vector<TreeEntry> entries;
    for (std::string line; std::getline(list, line, '\0');) {
      const std::size_t tab = line.find('\t');
      std::istringstream words(line.substr(0, tab));
      TreeEntry& entry = entries.emplace_back();
      std::string type;
      words >> entry.mode >> type >> entry.object;
      entry.path = line.substr(tab + 1);
    }
    return entries;
  }

  /// Returns the output of `cat-file --batch` for the files of a list.
  std::string contents(const std::vector<TreeEntry>& entries) const {
    std::string objects;
    for (const TreeEntry& entry : entries) objects += entry.object + "\n";
    return checked(call({"cat-file", "--batch"}, std::move(objects)), "the files cannot be read");
  }

 private:
  std::string path() const { return folder_.path() + "/repository"; }

  ProcessResult call(std::vector<std::string> arguments, std::string input = "") const {
    arguments.insert(arguments.begin(), "--git-dir=" + path());
    return git(std::move(arguments), std::move(input));
  }

  /// Takes the commit alone; from servers that do not give single commits, all branches and tags.
  void take(const std::string& url, const std::string& commit) const {
    const std::vector<std::string> fetch{"fetch", "-q", "--no-tags", "--no-recurse-submodules"};
    const auto with = [&](std::vector<std::string> more) {
      std::vector<std::string> all = fetch;
      all.insert(all.end(), more.begin(), more.end());
      return call(std::move(all));
    };
    if (with({"--depth=1", "--", url, commit}).succeeded()) return;
    checked(with({"--", url, "+refs/heads/*:refs/all/heads/*", "+refs/tags/*:refs/all/tags/*"}),
            fmt::format("git cannot read {}", text::visible(url)));
    if (!call({"cat-file", "-e", commit}).succeeded())
      throw FetchProblem(fmt::format("{} has no commit {}; a branch or tag of it must contain the commit",
                                     text::visible(url), commit));
  }

  void refuse_tag(const std::string& commit) const {
    const std::string type = checked(call({"cat-file", "-t", commit}), "no commit");
    if (type == "commit\n") return;
    const ProcessResult found = call({"rev-parse", "--verify", "-q", commit + "^{commit}"});
    throw FetchProblem(fmt::format("{} is no commit{}", commit,
                                   found.succeeded() ? "; write rev: " + found.output.substr(0, 40) : ""));
  }

  subprocess::ScratchFolder folder_;
};

/// Refuses a path that is not below the folder, or that git itself would not check out.
void check_path(const std::string& path) {
  const auto is_bad = [](const fs::path& piece) {
    std::string name = piece.string();
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
    return name.empty() || name == "." || name == ".." || name == ".git";
  };
  const fs::path file(path);
  if (file.is_absolute() || std::ranges::any_of(file, is_bad))
    throw FetchProblem(fmt::format("the repository has a file '{}', which is refused", text::visible(path)));
}

[[noreturn]] void refuse_link(const std::string& path, const std::string& target) {
  throw FetchProblem(fmt::format("the link '{}' leads out of the repository, to '{}'; it is refused",
                                 text::visible(path), text::visible(target)));
}

void check_link(const std::string& path, const std::string& target, const std::string& folder) {
  const fs::path full = fs::path(folder) / fs::path(path).parent_path() / target;
  if (!io::is_below(full.string(), folder)) refuse_link(path, target);
}

/// Splits the next content from the output of `cat-file --batch`: "OBJECT blob SIZE", a line end, the bytes.
std::string_view next_content(std::string_view& output) {
  const std::size_t line = output.find('\n'), space = output.rfind(' ', line);
  std::size_t size = 0;
  std::istringstream(std::string(output.substr(space + 1, line - space - 1))) >> size;
  if (line == output.npos || output.size() < line + 1 + size)
    throw FetchProblem("the files of the commit are incomplete");
  const std::string_view content = output.substr(line + 1, size);
  output.remove_prefix(std::min(output.size(), line + 2 + size));
  return content;
}

bool is_pointer(std::string_view content) {
  return content.starts_with("version https://git-lfs.github.com/spec/");
}

void make_link(const std::string& path, const std::string& target) {
  std::error_code error;
  fs::create_directories(fs::path(path).parent_path(), error);
  fs::create_symlink(target, path, error);
  if (error) throw FetchProblem(fmt::format("{}: {}", path, error.message()));
}

/// Refuses a path that occurs twice, and one below a file or a link. git itself makes no such commit, but
/// takes it from others.
void check_tree(const std::vector<TreeEntry>& entries) {
  std::set<std::string> paths;
  const auto refuse = [](const std::string& path) {
    throw FetchProblem(
        fmt::format("the commit has '{}' twice, or a path below it; it is refused", text::visible(path)));
  };
  for (const TreeEntry& entry : entries)
    if (!paths.insert(fs::path(entry.path).lexically_normal().string()).second) refuse(entry.path);
  for (const std::string& path : paths)
    for (fs::path above = fs::path(path).parent_path(); !above.empty(); above = above.parent_path())
      if (paths.contains(above.string())) refuse(above.string());
}

/// Writes files, then links. A link that would lead out of the folder by its text is not made; one that does
/// so by other links is found once all of them are there.
void write_entries(const std::vector<TreeEntry>& entries, std::string_view contents,
                   const std::string& folder, WrittenFiles& written) {
  std::vector<std::pair<std::string, std::string>> links;
  for (const TreeEntry& entry : entries) {
    const std::string_view content = next_content(contents);
    if (is_pointer(content))
      written.left_out.push_back(entry.path + " is a pointer of Git LFS, whose content is not fetched");
    if (entry.is_link())
      links.emplace_back(entry.path, content);
    else
      io::write_file(folder + "/" + entry.path, content);
  }
  for (const auto& [path, target] : links) {
    const fs::path full = (fs::path(folder) / fs::path(path).parent_path() / target).lexically_normal();
    if (fs::path(target).is_absolute() || full.lexically_relative(folder).string().starts_with(".."))
      refuse_link(path, target);
    make_link(folder + "/" + path, target);
  }
  for (const auto& [path, target] : links) check_link(path, target, folder);
  written.files = entries.size();
}

}  // namespace

WrittenFiles write_commit(const std::string& url, const std::string& commit, const std::string& folder) {
  const Repository repository(url, commit);
  std::vector<TreeEntry> entries = repository.entries(commit);
  WrittenFiles written;
  for (const TreeEntry& entry : entries) {
    check_path(entry.path);
    if (entry.is_submodule())
      written.left_out.push_back(entry.path + " is a submodule, which is not fetched");
  }
  std::erase_if(entries, [](const TreeEntry& entry) { return entry.is_submodule(); });
  check_tree(entries);
  write_entries(entries, repository.contents(entries), folder, written);
  return written;
}

std::optional<std::string> commit_of_name(const std::string& url, const std::string& name) {
  const ProcessResult result = git({"ls-remote", "--", url, name, name + "^{}"});
  std::istringstream lines(checked(result, fmt::format("git cannot read {}", text::visible(url))));
  std::optional<std::string> commit;
  for (std::string line; std::getline(lines, line);) {
    const std::string hash = line.substr(0, line.find('\t')), found = line.substr(line.find('\t') + 1);
    const bool is_tag_itself = found.ends_with("^{}");
    if (!commit || is_tag_itself) commit = hash;
    if (is_tag_itself) break;  // the commit of an annotated tag
  }
  return commit;
}

}  // namespace stepwire::fetch
