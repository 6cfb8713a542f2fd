#include "engine/base/io/inside.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "engine/base/io/environment_error.hpp"

namespace stepwire::io {
namespace {

namespace fs = std::filesystem;

}  // namespace

bool is_below(const std::string& path, const std::string& folder) {
  std::error_code error;
  const fs::path file = fs::weakly_canonical(fs::absolute(path), error);
  if (error) return false;
  const fs::path root = fs::weakly_canonical(fs::absolute(folder), error);
  if (error) return false;
  const auto [end, at] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
  return end == root.end() || (end->empty() && std::next(end) == root.end());  // a folder may end in '/'
}

bool is_inside(const std::string& path) {
  const char* const listed = std::getenv(inside_variable);
  if (!listed) return true;
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error);
  if (!error && is_below(path, temporary.string())) return true;
  std::istringstream folders(listed);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty() && is_below(path, folder)) return true;
  return false;
}

void require_inside(const std::string& path) {
  if (is_inside(path)) return;
  throw EnvironmentError(path + ": this file is outside of the folder of the call; name one inside");
}

}  // namespace stepwire::io
