#include "tests/house/source_tree.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace {

const std::filesystem::path top = STEPWIRE_SOURCE_DIR;

/// Neither written by us nor kept: what is built, and what others wrote.
bool is_foreign(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const bool at_top = path.parent_path() == top;
  return name == "node_modules" || (at_top && (name == ".git" || name == "out" || name.starts_with("build")));
}

std::vector<std::string> files_ending_with(const std::set<std::string>& endings,
                                           const std::vector<std::string>& folders) {
  std::vector<std::string> found;
  for (const std::string& folder : folders)
    for (const std::string& file : files_under(folder))
      if (endings.contains(std::filesystem::path(file).extension().string())) found.push_back(file);
  return found;
}

}  // namespace

std::vector<std::string> files_under(const std::string& folder) {
  std::vector<std::string> files;
  if (!std::filesystem::is_directory(top / folder)) return files;
  for (auto at = std::filesystem::recursive_directory_iterator(top / folder);
       at != std::filesystem::recursive_directory_iterator(); ++at) {
    if (is_foreign(at->path())) {
      at.disable_recursion_pending();
    } else if (at->is_regular_file()) {
      files.push_back(at->path().lexically_relative(top).string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Line> lines_of(const std::string& file) {
  std::ifstream in(top / file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::vector<Line> lines;
  if (text.find('\0') != std::string::npos) return lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back({file, static_cast<int>(lines.size()) + 1, std::move(line)});
  return lines;
}

std::vector<std::string> sources_under(const std::vector<std::string>& folders) {
  return files_ending_with({".cpp", ".hpp"}, folders);
}

std::vector<std::string> all_sources_under(const std::vector<std::string>& folders) {
  return files_ending_with({".cpp", ".hpp", ".ts", ".mjs", ".py"}, folders);
}

std::string folder_of(const std::string& file) {
  return std::filesystem::path(file).parent_path().string();
}
