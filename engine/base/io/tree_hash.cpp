#include "engine/base/io/tree_hash.hpp"

#include <filesystem>
#include <map>

#include "engine/base/hash/sha256.hpp"
#include "engine/base/io/file.hpp"

namespace stepwire::io {

namespace fs = std::filesystem;

static std::string content_of(const fs::directory_entry& entry) {
  if (entry.is_symlink()) return "link:" + fs::read_symlink(entry.path()).string();
  if (!entry.is_regular_file()) throw EnvironmentError(entry.path().string() + ": is no file");
  return read_file(entry.path().string());
}

TreeHash tree_hash(const std::string& folder) try {
  std::map<std::string, std::string> hashes;  // std::string orders by bytes
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_symlink() || !entry.is_directory())
      hashes[entry.path().lexically_relative(folder).generic_string()] = hash::sha256_of(content_of(entry));
  std::string list;
  for (const auto& [path, hash] : hashes) (list += path).append(1, '\0').append(hash) += '\n';
  return {hash::sha256_of(list), hashes.size()};
} catch (const fs::filesystem_error& error) {
  throw EnvironmentError(folder + ": " + error.code().message());
}

}  // namespace stepwire::io
