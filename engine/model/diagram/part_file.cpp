#include "engine/model/diagram/part_file.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "engine/base/io/resources.hpp"

namespace stepwire::diagram {

namespace {

namespace fs = std::filesystem;

constexpr const char* own_parts = "stepwire/";

bool is_there(const fs::path& path) {
  std::error_code none;
  return fs::exists(path, none);
}

std::vector<std::string> part_folders() {
  std::vector<std::string> folders;
  const char* named = std::getenv("STEPWIRE_PARTS");
  std::istringstream list(named ? named : "");
  for (std::string folder; std::getline(list, folder, ':');)
    if (!folder.empty()) folders.push_back(folder);
  return folders;
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

}  // namespace

std::string part_file(const std::string& user, const std::string& path) {
  const fs::path beside = (fs::path(user).parent_path() / path).lexically_normal();
  if (is_there(beside)) return beside.string();
  if (const std::string own = own_part(path); !own.empty()) return own;
  for (const std::string& folder : part_folders())
    if (const fs::path file = fs::path(folder) / path; is_there(file))
      return file.lexically_normal().string();
  return beside.string();
}

std::string other_part_places(const std::string& path) {
  const auto folders = part_folders();
  if (path.starts_with(own_parts) || fs::path(path).is_absolute()) return "";
  return folders.empty() ? "" : fmt::format("; it is not in {} either", fmt::join(folders, ", "));
}

}  // namespace stepwire::diagram
