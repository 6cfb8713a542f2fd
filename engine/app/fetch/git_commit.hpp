#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace stepwire::fetch {

/// Thrown where the files of a commit cannot be had; the text has the problem and the cure.
class FetchProblem : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Files of one commit that were written into a folder.
struct WrittenFiles {
  std::size_t files = 0;              ///< number of files and links
  std::vector<std::string> left_out;  ///< a sentence for each submodule, and for each pointer of Git LFS
};

/// Writes all files of a commit of a repository into an empty folder. The files are those of the repository,
/// byte by byte: filters, line ends and attributes of git do not apply. Submodules are not fetched.
/// Throws FetchProblem for an unreachable repository, an unknown commit, the name of a tag in its
/// place, a path that leads out of the folder, and a symbolic link that does. Throws EnvironmentError where
/// the system refuses a file.
WrittenFiles write_commit(const std::string& url, const std::string& commit, const std::string& folder);

/// Returns the commit of a tag or branch at present; std::nullopt if the repository has no such name.
/// Throws FetchProblem for an unreachable repository.
std::optional<std::string> commit_of_name(const std::string& url, const std::string& name);

}  // namespace stepwire::fetch
