#include "engine/app/studio/named_files.hpp"

#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace stepwire::studio {

namespace {

namespace fs = std::filesystem;

/// Resolves a file name of a diagram: "data/..." in the data folder, others in the folder of the diagram.
fs::path written_path(const std::string& text, const fs::path& folder) {
  const fs::path path(text);
  if (!path.is_absolute() && *path.begin() == "data" && !data_folder().empty())
    return data_folder() / path.lexically_relative("data");
  return folder / path;
}

/// True for anything readable that is not a folder.
bool is_file(const fs::path& path) {
  std::error_code none;
  const fs::file_status status = fs::status(path, none);
  return fs::exists(status) && !fs::is_directory(status);
}

class Search {
 public:
  explicit Search(const yaml::Document& document) : folder_(fs::path(document.file).parent_path()) {
    look(document.root, "");
  }

  std::vector<NamedFile> found;

 private:
  void look(const yaml::Node& node, std::string_view key) {
    if (node.is_scalar()) take(node, key);
    for (const yaml::Entry& entry : node.entries) look(entry.value, entry.key);
    for (const yaml::Node& item : node.items) look(item, key);
  }

  void take(const yaml::Node& node, std::string_view key) {
    constexpr std::size_t longest = 4096;
    const std::string& text = node.text;
    if (text.empty() || text.size() > longest || text.find_first_of(std::string_view("\n\0", 2)) != text.npos)
      return;
    const fs::path written = written_path(text, folder_), path = written.lexically_normal();
    if (!is_file(written) && (text.find("..") == text.npos || !is_file(path))) return;
    std::error_code none;
    const bool is_plain = fs::weakly_canonical(written, none) == fs::weakly_canonical(path, none);
    const bool is_diagram = key == "diagram" || path.extension() == ".yaml" || path.extension() == ".yml";
    found.push_back({path.string(), text, node.mark, is_diagram, is_plain});
  }

  fs::path folder_;
};

}  // namespace

std::string data_folder() {
  const char* named = std::getenv("STEPWIRE_DATA");
  if (!named || !*named) return "";
  std::error_code none;
  const fs::path folder = fs::weakly_canonical(named, none);
  return none ? named : folder.string();
}

std::vector<NamedFile> named_files(const yaml::Document& document) {
  return Search(document).found;
}

}  // namespace stepwire::studio
