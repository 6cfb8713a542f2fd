#include "engine/app/language/part_files.hpp"

#include <filesystem>

namespace stepwire::language {

namespace {

/// Returns the value in the line of a top-level key, without parsing the file.
std::string line_of(std::string_view text, const std::string& key) {
  const std::size_t at = text.starts_with(key) ? 0 : text.find("\n" + key);
  if (at == std::string_view::npos) return "";
  const std::size_t begin = at + key.size() + (text[at] == '\n' ? 1 : 0);
  const std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
  const std::size_t first = line.find_first_not_of(' ');
  return first == std::string_view::npos ? " " : std::string(line.substr(first));
}

}  // namespace

std::vector<PartFile> part_files(DiagramFiles& files, const std::string& user) {
  std::vector<PartFile> parts;
  const auto folder = std::filesystem::path(user).parent_path();
  for (const std::string& file : files.paths()) {
    if (file == user) continue;
    const auto text = files.texts().text(file);
    if (line_of(*text, "stepwire:").empty() || line_of(*text, "outputs:").empty()) continue;
    parts.push_back(
        {std::filesystem::path(file).lexically_relative(folder).string(), line_of(*text, "title:")});
  }
  return parts;
}

}  // namespace stepwire::language
