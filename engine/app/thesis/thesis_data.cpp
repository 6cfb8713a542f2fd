#include "engine/app/thesis/thesis_data.hpp"

#include <filesystem>
#include <map>

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/mat/deflate.hpp"
#include "engine/base/mat/mat_file.hpp"

namespace stepwire::thesis {
namespace {

namespace fs = std::filesystem;

/// From these sizes on data files are shared, and CSV files packed: smaller ones open at once in any program
/// [bytes].
constexpr std::uintmax_t shared_from = 50'000, packed_from = 500'000;

void pack_file(const fs::path& path) {
  const std::string place = path.string();
  if (path.extension() == ".mat") return io::write_file(place, mat::packed_mat(io::read_file(place)));
  if (path.extension() != ".csv" || fs::file_size(path) < packed_from) return;
  io::write_file(place + ".gz", mat::gzip_packed(io::read_file(place)));
  fs::remove(path);
}

bool is_shared(const gallery::GalleryDownload& file) {
  const bool is_data =
      file.file.ends_with(".mat") || file.file.ends_with(".csv") || file.file.ends_with(".gz");
  return is_data && file.bytes >= shared_from;
}

/// The entry that keeps a file.
struct Keeper {
  std::string folder, label;
};

}  // namespace

void pack_data(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& file : fs::directory_iterator(folder, error))
    if (file.is_regular_file(error)) files.push_back(file.path());
  for (const fs::path& file : files) pack_file(file);
}

void share_data(const std::string& out, std::vector<gallery::GalleryEntry>& entries) {
  std::map<std::string, Keeper> keepers;
  for (gallery::GalleryEntry& entry : entries)
    for (gallery::GalleryDownload& file : entry.downloads) {
      if (!is_shared(file)) continue;
      const fs::path path = fs::path(out) / entry.folder / file.file;
      const std::string content = file.file + " " + hash::hash_of(io::read_file(path.string()));
      const auto [keeper, is_first] = keepers.try_emplace(content, Keeper{entry.folder, entry.label});
      if (is_first) continue;
      file.folder = keeper->second.folder;
      file.label = keeper->second.label;
      fs::remove(path);
    }
}

}  // namespace stepwire::thesis
