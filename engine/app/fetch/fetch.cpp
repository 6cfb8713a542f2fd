#include "engine/app/fetch/fetch.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "engine/app/fetch/git_commit.hpp"
#include "engine/base/io/cache.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/leftovers.hpp"
#include "engine/base/io/temporary.hpp"
#include "engine/base/io/tree_hash.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/model/diagram/part_file.hpp"

namespace stepwire::fetch {
namespace {

namespace fs = std::filesystem;
using diagram::Use;
using yaml::Message;

/// Returns the address as git takes it; a relative path begins at the folder of the file.
std::string address_of(const Use& use, const std::string& file) {
  return diagram::is_path_address(use.git)
             ? fs::absolute(fs::path(file).parent_path() / use.git).lexically_normal().string()
             : use.git;
}

bool has_right_files(const Use& use) {
  const std::string folder = diagram::fetched_folder(use);
  std::error_code none;
  return diagram::is_sha256(use.sha256) && fs::is_directory(folder, none) &&
         io::tree_hash(folder).sha256 == use.sha256;
}

/// Folder beside those of the cache, removed with its content unless it is kept.
class NewFolder {
 public:
  NewFolder() : path_(io::temporary_beside(io::cache_folder() + "/parts/new")), leftover_(path_, true) {
    std::error_code ignored;  // an error here appears again below
    fs::create_directories(fs::path(io::cache_folder()).parent_path(), ignored);
    ::mkdir(io::cache_folder().c_str(), 0700);
    io::require_folder(path_);
    ::chmod(path_.c_str(), 0700);
  }
  ~NewFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  const std::string& path() const { return path_; }
  /// Moves the folder to its place, where damaged files may be.
  void keep(const std::string& place) const {
    std::error_code error;
    if (fs::is_directory(place, error) && io::tree_hash(place).sha256 == io::tree_hash(path_).sha256) return;
    fs::remove_all(place, error);
    fs::rename(path_, place, error);
    if (error) throw io::EnvironmentError(place + ": " + error.message());
  }

 private:
  std::string path_;
  io::Leftover leftover_;
};

/// Walk through files and their parts.
class Walk {
 public:
  /// Visits a diagram and its parts, in which one name has one version. Other diagrams may use another one.
  void visit_diagram(const std::string& file) {
    seen_.clear();
    known_.clear();
    visit(file);
  }

  Fetched result;

 private:
  void visit(const std::string& file) {
    if (!seen_.insert(fs::path(file).lexically_normal().string()).second) return;
    const yaml::Document document = yaml::read_document(file);
    for (const Use& use : diagram::uses_of(document.root)) take(use, document);
    const yaml::Node* blocks = document.root.is_map() ? document.root.find("blocks") : nullptr;
    for (std::size_t i = 0; blocks && i < blocks->entries.size(); ++i)
      visit_part(document, blocks->entries[i].value);
  }

  void visit_part(const yaml::Document& document, const yaml::Node& block) {
    const yaml::Node* path = block.is_map() ? block.find("diagram") : nullptr;
    if (!path || !path->is_scalar()) return;
    const std::string part = diagram::part_file(document, path->text);
    std::error_code none;
    if (fs::is_regular_file(part, none)) visit(part);
  }

  void refuse(const yaml::Mark& mark, const Use& use, const std::string& file, const Message& message) {
    yaml::Fault fault{{file, mark}, "uses." + use.name, message, {}};
    if (told_.insert(fault.text()).second) result.faults.push_back(std::move(fault));
  }

  /// True for an entry that cannot be fetched as it is written; adds its fault.
  bool is_wrong(const Use& use, const std::string& file) {
    const std::size_t before = result.faults.size();
    if (const Message problem = diagram::name_problem(use.name, file); !problem.empty())
      refuse(use.mark, use, file, problem);
    const Message problem = diagram::git_problem(use.git, file);
    if (!problem.empty())
      refuse(use.mark, use, file, problem);
    else if (!diagram::is_full_commit(use.rev))
      refuse(use.rev_mark, use, file, problem_of_rev(use, file));
    return result.faults.size() > before;
  }

  static Message problem_of_rev(const Use& use, const std::string& file) try {
    const std::string problem = fmt::format("'{}' is no commit of 40 digits", text::visible(use.rev));
    constexpr auto plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._/+-";
    const bool is_name =
        !use.rev.empty() && use.rev.front() != '-' && use.rev.find_first_not_of(plain) == std::string::npos;
    const auto commit = is_name ? commit_of_name(address_of(use, file), use.rev) : std::nullopt;
    if (!commit) return Message(problem, "the repository has no tag or branch of this name either");
    return Message(problem + " but a name that may move", "at present it is rev: " + *commit);
  } catch (const FetchProblem& fault) {
    return Message(fault.what());
  }

  void take(const Use& use, const yaml::Document& document) {
    if (is_wrong(use, document.file)) return;
    const yaml::Place place{document.file, use.mark};
    const auto [known, is_new] = known_.try_emplace(use.name, use, place);
    const auto& [other, other_place] = known->second;
    if (!is_new && !use.is_version_of(other))
      return refuse(use.mark, use, document.file, diagram::versions_problem(use, other, other_place));
    if (!is_new || !taken_.insert({address_of(use, document.file), use.rev, use.sha256}).second) return;
    FetchedUse fetched{.use = use, .file = document.file, .was_there = has_right_files(use)};
    if (fetched.was_there)
      fetched.files = io::tree_hash(diagram::fetched_folder(use)).files;
    else if (!get(fetched))
      return;
    result.uses.push_back(std::move(fetched));
  }

  /// Writes the files of an entry into the cache. Returns false with a fault if they are not the right ones.
  bool get(FetchedUse& fetched) try {
    const Use& use = fetched.use;
    const NewFolder folder;
    WrittenFiles written = write_commit(address_of(use, fetched.file), use.rev, folder.path());
    Use right = use;
    right.sha256 = io::tree_hash(folder.path()).sha256;
    folder.keep(diagram::fetched_folder(right));
    fetched.files = written.files;
    fetched.left_out = std::move(written.left_out);
    if (right.sha256 == use.sha256) return true;
    refuse(use.sha256_mark, use, fetched.file,
           Message(use.sha256.empty() ? "has no sha256"
                                      : fmt::format("the files of {} do not have the sha256 '{}'", use.rev,
                                                    text::visible(use.sha256)),
                   (use.sha256.empty() ? "write sha256: " : "theirs is sha256: ") + right.sha256));
    return false;
  } catch (const FetchProblem& problem) {
    refuse(fetched.use.mark, fetched.use, fetched.file, Message(problem.what()));
    return false;
  }

  std::set<std::string> seen_;                                ///< Files of this diagram.
  std::map<std::string, std::pair<Use, yaml::Place>> known_;  ///< Versions in it.
  std::set<std::array<std::string, 3>> taken_;                ///< Versions of all diagrams.
  std::set<std::string> told_;                                ///< Faults of shared parts.
};

}  // namespace

Fetched fetch_parts(const std::vector<std::string>& files) {
  if (io::cache_folder().empty())
    throw io::EnvironmentError("the cache has no place; HOME or STEPWIRE_CACHE name one");
  Walk walk;
  for (const std::string& file : files) walk.visit_diagram(file);
  return std::move(walk.result);
}

}  // namespace stepwire::fetch
