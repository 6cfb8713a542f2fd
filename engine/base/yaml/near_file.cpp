#include "engine/base/yaml/near_file.hpp"

#include <filesystem>
#include <system_error>

#include "engine/base/io/inside.hpp"

namespace stepwire::yaml {

namespace fs = std::filesystem;

std::vector<std::string> files_of(const std::string& folder, const std::string& ending,
                                  const std::string& prefix) {
  constexpr std::size_t most = 5000;
  if (!io::is_inside(folder.empty() ? "." : folder)) return {};
  std::vector<std::string> names;
  std::error_code none;
  fs::directory_iterator entry(folder.empty() ? "." : folder, none);
  for (; !none && entry != fs::directory_iterator() && names.size() < most; entry.increment(none))
    if (entry->path().extension() == ending && !entry->is_directory(none))
      names.push_back(prefix + entry->path().filename().string());
  return names;
}

Message near_file(const std::string& path) {
  const fs::path file(path);
  const std::string name = file.filename().string(), prefix = path.substr(0, path.size() - name.size());
  Message message = did_you_mean(name, files_of(prefix, file.extension().string(), ""));
  if (!message.suggestion) return message;
  const std::string meant = prefix + message.suggestion->meant;
  return {"", "did you mean '" + meant + "'?", Suggestion{path, meant}};
}

}  // namespace stepwire::yaml
