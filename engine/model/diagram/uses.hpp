#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/base/yaml/key.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// Entry of the section `uses`: one commit of a repository of git, whose files are parts.
struct Use {
  std::string name{}, git{}, rev{}, sha256{};
  yaml::Mark mark{};         ///< of its name
  yaml::Mark rev_mark{};     ///< of the value of `rev`
  yaml::Mark sha256_mark{};  ///< of the value of `sha256`; that of the name without one

  bool is_version_of(const Use& other) const { return rev == other.rev && sha256 == other.sha256; }
};

/// Form of an entry of `uses`.
const yaml::Key& use_form();

/// Returns the entries of a file as they are written, without any check.
std::vector<Use> uses_of(const yaml::Node& root);
/// Returns the entry with which the path of a part begins: `rig` for "rig/oscillator".
std::optional<Use> use_of(const yaml::Node& root, const std::string& path);

/// Returns what is wrong with the name of an entry in `file`; empty if nothing.
yaml::Message name_problem(const std::string& name, const std::string& file);
/// Returns what is wrong with an address; empty for https, ssh, file:// and paths. Addresses by which git
/// runs programs are refused, and addresses with a password. In a fetched file a relative path is refused.
yaml::Message git_problem(const std::string& git, const std::string& file);
/// True for an address that is a path for git: it has no scheme, and no colon before the first slash.
bool is_path_address(const std::string& git);
/// True for the 40 hexadecimal digits of a commit.
bool is_full_commit(const std::string& rev);
/// True for 64 hexadecimal digits.
bool is_sha256(const std::string& text);
/// Returns the message about two versions of one name, of which the other has this place.
yaml::Message versions_problem(const Use& use, const Use& other, const yaml::Place& place);

/// Returns the folder of the cache that has the files of an entry.
std::string fetched_folder(const Use& use);
/// Returns the file of a part whose path begins with the name of the entry. The ending .yaml may be left out.
std::string fetched_file(const Use& use, const std::string& path);
/// Returns the folder of the fetched files that contains a file; empty for others.
std::string fetched_root(const std::string& file);
/// True for a path below a folder, by its text alone.
bool is_in_folder(const std::string& path, const std::string& folder);

/// Returns the repositories whose files are parts of a diagram, each once. Commit and hash are those of the
/// loaded files; name and address are read from the file that uses them, and empty if it has changed.
std::vector<Use> used_repositories(const Diagram& diagram);

/// Checks fetched files against their hashes, each folder once.
class FetchedTrees {
 public:
  /// Returns why the files of an entry cannot be used; empty if they can. `file` is that of the cure
  /// `stepwire fetch FILE`. Throws EnvironmentError for unreadable files.
  yaml::Message problem(const Use& use, const std::string& file);

 private:
  std::map<std::string, std::string> hashes_;
};

}  // namespace stepwire::diagram
