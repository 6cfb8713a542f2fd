#include "engine/simulate/replay/data_copies.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>

#include "engine/base/io/file.hpp"
#include "engine/model/diagram/flatten.hpp"

namespace stepwire::replay {

namespace {

/// Returns the name with '_' for all but letters, digits, '.', '-' and '_'.
std::string safe(std::string name) {
  const auto is_safe = [](unsigned char c) { return std::isalnum(c) || c == '.' || c == '-' || c == '_'; };
  std::replace_if(name.begin(), name.end(), std::not_fn(is_safe), '_');
  return name;
}

}  // namespace

const std::string& DataCopies::name_of(const std::string& path) {
  const auto [copy, is_new] = copies_.try_emplace(diagram::absolute_path(path));
  if (!is_new) return copy->second.name;
  copy->second = {free_name(path), io::read_file(path)};
  taken_.insert(copy->second.name);
  return copy->second.name;
}

std::string DataCopies::free_name(const std::string& path) const {
  const std::filesystem::path file(path);
  std::string stem = safe(file.stem().string());
  if (stem.starts_with('-') || stem.starts_with('.')) stem.insert(0, "_");  // no option, no hidden file
  const std::string ending = safe(file.extension().string());
  for (std::size_t index = 0;; ++index)
    if (std::string name = io::numbered(stem, index, ending); !taken_.contains(name)) return name;
}

void DataCopies::write(const std::string& folder) const {
  for (const auto& [path, copy] : copies_) io::write_file(folder + "/" + copy.name, copy.content);
}

}  // namespace stepwire::replay
