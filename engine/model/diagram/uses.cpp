#include "engine/model/diagram/uses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include "engine/base/io/cache.hpp"
#include "engine/base/io/tree_hash.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/model/diagram/keys.hpp"

namespace stepwire::diagram {

namespace {

namespace fs = std::filesystem;
using yaml::Message;

bool is_hexadecimal(const std::string& text, std::size_t digits) {
  return text.size() == digits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string text_under(const yaml::Node& map, const char* key, yaml::Mark* mark = nullptr) {
  const yaml::Node* node = map.is_map() ? map.find(key) : nullptr;
  if (node && mark) *mark = node->mark;
  return node && node->is_scalar() ? node->text : "";
}

std::string parts_cache() {
  return io::cache_folder() + "/parts";
}

/// True for the forms of an address by which git connects to another machine.
bool is_remote(const std::string& git) {
  static const std::regex https(R"(https://[A-Za-z0-9][^@]*)");
  static const std::regex ssh(R"(ssh://[A-Za-z0-9_][A-Za-z0-9_.-]*@[A-Za-z0-9][A-Za-z0-9.-]*[:/][^-].*)");
  static const std::regex short_ssh(R"([A-Za-z0-9_][A-Za-z0-9_.-]*@[A-Za-z0-9][A-Za-z0-9.-]*:[^-].*)");
  static const std::regex ssh_alone(R"(ssh://[A-Za-z0-9][A-Za-z0-9.-]*[:/][^-@][^@]*)");
  return std::regex_match(git, https) || std::regex_match(git, ssh) || std::regex_match(git, short_ssh) ||
         std::regex_match(git, ssh_alone);
}

bool has_control_characters(const std::string& text) {
  return std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

}  // namespace

const yaml::Key& use_form() {
  using yaml::form;
  static const yaml::Key form =
      form::keys("an entry of uses", "{git: https://example.org/rig.git, rev: COMMIT, sha256: HASH}",
                 {yaml::needed(yaml::key("git", "address of the repository: https, ssh, file:// or a path",
                                         form::string())),
                  yaml::needed(yaml::key("rev", "its commit, all 40 digits", form::string())),
                  yaml::needed(yaml::key("sha256", "hash of its files, which `stepwire fetch` prints",
                                         form::string()))});
  return form;
}

std::vector<Use> uses_of(const yaml::Node& root) {
  std::vector<Use> uses;
  const yaml::Node* section = root.is_map() ? root.find("uses") : nullptr;
  if (!section || !section->is_map()) return uses;
  for (const yaml::Entry& entry : section->entries) {
    Use use{.name = entry.key, .mark = entry.mark, .rev_mark = entry.mark, .sha256_mark = entry.mark};
    use.git = text_under(entry.value, "git");
    use.rev = text_under(entry.value, "rev", &use.rev_mark);
    use.sha256 = text_under(entry.value, "sha256", &use.sha256_mark);
    uses.push_back(std::move(use));
  }
  return uses;
}

std::optional<Use> use_of(const yaml::Node& root, const std::string& path) {
  const std::size_t slash = path.find('/');
  if (slash == std::string::npos) return std::nullopt;
  for (Use& use : uses_of(root))
    if (use.name == path.substr(0, slash)) return std::move(use);
  return std::nullopt;
}

Message name_problem(const std::string& name, const std::string& file) {
  if (!is_name(name)) return "is no name; use letters, digits and '_'";
  if (name == "stepwire") return "is the name of the parts of this program; choose another name";
  std::error_code none;
  if (fs::exists(fs::path(file).parent_path() / name, none))
    return "is also the name of a file or folder here, so that its parts have two meanings; choose another "
           "name";
  return {};
}

bool is_path_address(const std::string& git) {
  return git.find("://") == std::string::npos && git.find(':') >= git.find('/');
}

/// Returns the problem of an address that is no path and has no scheme; empty for user@host:path.
static Message short_address_problem(const std::string& git, const std::string& file) {
  std::error_code none;
  const bool is_there = fs::exists(fs::path(file).parent_path() / git, none);
  if (is_remote(git) && !is_there) return {};
  return Message(fmt::format("'{}' {}", text::visible(git),
                             is_there ? "is a path here, and git takes it for an address" : "has no user"),
                 fmt::format("write ./{} for the path{}", text::visible(git),
                             is_remote(git) ? ", or ssh://user@host/path" : ", or user@host:path"));
}

Message git_problem(const std::string& git, const std::string& file) {
  constexpr const char* allowed = "write an address with https://, ssh://, user@host:path, file:// or a path";
  if (git.empty()) return Message("has no address", allowed);
  if (has_control_characters(git) || git.starts_with('-') || git.find("::") != std::string::npos)
    return yaml::fault_text("'{}' is no address; {}", text::visible(git), allowed);
  if (git.find("://") == std::string::npos && !is_path_address(git)) return short_address_problem(git, file);
  if (is_remote(git)) return {};
  const bool is_url = git.find("://") != std::string::npos, is_file = git.starts_with("file:///");
  if (is_url && git.find('@') != std::string::npos)
    return Message("has a name or password in the address", "git asks its credential helper for these");
  if (is_url && !is_file) return yaml::fault_text("'{}' is not allowed; {}", text::visible(git), allowed);
  if (!is_file && git.front() != '/' && !fetched_root(file).empty())
    return yaml::fault_text("'{}' is a relative path in a fetched file; {}", text::visible(git), allowed);
  return {};
}

bool is_full_commit(const std::string& rev) {
  return is_hexadecimal(rev, 40);
}

bool is_sha256(const std::string& text) {
  return is_hexadecimal(text, 64);
}

Message versions_problem(const Use& use, const Use& other, const yaml::Place& place) {
  return yaml::fault_text("{} is at {} here and at {} in {}:{}:{}; use one version in all files", use.name,
                          use.rev + (use.rev == other.rev ? " with sha256 " + use.sha256 : ""),
                          other.rev + (use.rev == other.rev ? " with sha256 " + other.sha256 : ""),
                          place.file, place.mark.line, place.mark.column);
}

std::string fetched_folder(const Use& use) {
  return fmt::format("{}/{}-{}", parts_cache(), use.rev, use.sha256);
}

std::string fetched_file(const Use& use, const std::string& path) {
  fs::path file = fs::path(fetched_folder(use)) / path.substr(use.name.size() + 1);
  if (file.extension() != ".yaml" && file.extension() != ".yml") file += ".yaml";
  return file.lexically_normal().string();
}

std::string fetched_root(const std::string& file) {
  const std::string cache = fs::path(parts_cache()).lexically_normal().string() + "/";
  const std::string path = fs::path(file).lexically_normal().string();
  if (!path.starts_with(cache)) return "";
  const std::size_t end = path.find('/', cache.size());
  return end == std::string::npos ? "" : path.substr(0, end);
}

bool is_in_folder(const std::string& path, const std::string& folder) {
  const std::string normal = fs::path(folder).lexically_normal().string();
  return fs::path(path).lexically_normal().string().starts_with(normal + "/");
}

namespace {

/// Returns the entry of a file with this commit and hash; only these two if the file has none.
Use use_with(const std::string& file, const std::string& rev, const std::string& sha256) try {
  const yaml::Document user = yaml::read_document(file);
  for (Use& use : uses_of(user.root))
    if (use.rev == rev && use.sha256 == sha256) return std::move(use);
  return {.rev = rev, .sha256 = sha256};
} catch (const yaml::Error&) {
  return {.rev = rev, .sha256 = sha256};
}

}  // namespace

std::vector<Use> used_repositories(const Diagram& diagram) {
  std::map<std::string, Use> uses;  // by folder
  for (const ScopeInfo& scope : diagram.scopes) {
    const std::string root = fetched_root(scope.file), folder = fs::path(root).filename().string();
    const std::size_t dash = folder.find('-');
    const auto& user = scope.used_at.scope >= 0
                           ? diagram.scopes[static_cast<std::size_t>(scope.used_at.scope)].file
                           : scope.file;
    if (root.empty() || fetched_root(user) == root || dash == std::string::npos) continue;
    if (!uses.contains(root)) uses[root] = use_with(user, folder.substr(0, dash), folder.substr(dash + 1));
  }
  std::vector<Use> all;
  for (auto& [root, use] : uses) all.push_back(std::move(use));
  std::ranges::sort(all, {}, &Use::name);
  return all;
}

Message FetchedTrees::problem(const Use& use, const std::string& file) {
  const std::string fetch = "`stepwire fetch " + text::shell_word(file) + "`";
  const std::string folder = fetched_folder(use);
  std::error_code none;
  if (!fs::is_directory(folder, none))
    return Message(fmt::format("{} at {} is not fetched", use.name, use.rev), fetch + " fetches it");
  auto& hash = hashes_[folder];
  if (hash.empty()) hash = io::known_tree_hash(folder);
  if (hash == use.sha256) return {};
  return Message(fmt::format("the fetched files of {} at {} were changed: their sha256 is {}, not {}",
                             use.name, use.rev, hash, use.sha256),
                 fetch + " fetches them again");
}

}  // namespace stepwire::diagram
