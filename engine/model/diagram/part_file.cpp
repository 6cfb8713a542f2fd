#include "engine/model/diagram/part_file.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "engine/base/io/resources.hpp"
#include "engine/base/yaml/near_file.hpp"
#include "engine/model/diagram/uses.hpp"

namespace stepwire::diagram {

namespace {

namespace fs = std::filesystem;

constexpr const char* own_parts = "stepwire/";

bool is_there(const fs::path& path) {
  std::error_code none;
  return fs::exists(path, none);
}

/// Returns the file of a part that comes with the program; empty for other paths, and if such parts are not
/// installed.
std::string own_part(const std::string& path) {
  if (!path.starts_with(own_parts)) return "";
  const std::string diagrams = io::find_resource("diagrams");
  if (diagrams.empty()) return "";
  fs::path file = fs::path(diagrams) / "parts" / path.substr(std::string(own_parts).size());
  if (file.extension() != ".yaml") file += ".yaml";
  return file.lexically_normal().string();
}

/// Returns the names of the parts that come with the program, "stepwire/oscillator".
std::vector<std::string> own_names(const std::string& ending) {
  const std::string diagrams = io::find_resource("diagrams");
  if (diagrams.empty()) return {};
  std::vector<std::string> names =
      yaml::files_of((fs::path(diagrams) / "parts").string(), ".yaml", own_parts);
  if (ending.empty())
    for (std::string& name : names) name.resize(name.size() - std::string(".yaml").size());
  return names;
}

}  // namespace

std::vector<std::string> part_folders() {
  std::vector<std::string> folders;
  const char* named = std::getenv("STEPWIRE_PARTS");
  std::istringstream list(named ? named : "");
  for (std::string folder; std::getline(list, folder, ':');)
    if (!folder.empty()) folders.push_back(folder);
  return folders;
}

std::string part_file(const std::string& user, const std::string& path) {
  const fs::path beside = (fs::path(user).parent_path() / path).lexically_normal();
  if (is_there(beside)) return beside.string();
  if (const std::string own = own_part(path); !own.empty()) return own;
  for (const std::string& folder : part_folders())
    if (const fs::path file = fs::path(folder) / path; is_there(file))
      return file.lexically_normal().string();
  return beside.string();
}

std::string part_file(const yaml::Document& user, const std::string& path) {
  const auto use = use_of(user.root, path);
  return use ? fetched_file(*use, path) : part_file(user.file, path);
}

yaml::Message near_part(const yaml::Document& user, const std::string& path) {
  const auto use = use_of(user.root, path);
  if (!use) return near_part(user.file, path);
  const fs::path part(path);
  const std::string ending = part.extension().string(), prefix = part.parent_path().string() + "/";
  const fs::path folder = fs::path(fetched_file(*use, path)).parent_path();
  std::vector<std::string> names = yaml::files_of(folder.string(), ".yaml", prefix);
  if (ending.empty())
    for (std::string& name : names) name.resize(name.size() - std::string(".yaml").size());
  return yaml::did_you_mean(path, names);
}

yaml::Message near_part(const std::string& user, const std::string& path) {
  const fs::path part(path);
  const std::string ending = part.extension().string(), name = part.filename().string();
  const std::string prefix = path.substr(0, path.size() - name.size());
  std::vector<std::string> names = own_names(ending);
  const auto add = [&](const fs::path& folder) {
    const auto more = yaml::files_of((folder / prefix).string(), ending.empty() ? ".yaml" : ending, prefix);
    names.insert(names.end(), more.begin(), more.end());
  };
  add(fs::path(user).parent_path());
  for (const std::string& folder : part_folders()) add(folder);
  return yaml::did_you_mean(path, names);
}

std::string other_part_places(const std::string& path) {
  const auto folders = part_folders();
  if (path.starts_with(own_parts) || fs::path(path).is_absolute()) return "";
  return folders.empty() ? "" : fmt::format(", nor in {}", fmt::join(folders, ", "));
}

}  // namespace stepwire::diagram
