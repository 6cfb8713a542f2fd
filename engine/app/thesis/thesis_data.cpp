#include "engine/app/thesis/thesis_data.hpp"

#include <filesystem>
#include <map>

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/mat/deflate.hpp"
#include "engine/base/parallel/parallel.hpp"

namespace stepwire::thesis {
namespace {

namespace fs = std::filesystem;

/// Sizes [bytes] from which CSV files are shared and packed. Smaller files open at once in any program.
constexpr std::uintmax_t shared_from = 50'000, packed_from = 500'000;

/// CSV file and the downloads that name it; the first one is of the entry that keeps the file.
struct DataFile {
  fs::path path;
  const gallery::GalleryEntry* keeper;
  std::vector<gallery::GalleryDownload*> downloads;
};

bool is_shared(const gallery::GalleryDownload& file) {
  return file.file.ends_with(".csv") && file.bytes >= shared_from;
}

/// Removes files whose content an earlier entry already has, and returns the remaining ones.
std::vector<DataFile> different_files(const std::string& out, std::vector<gallery::GalleryEntry>& entries) {
  std::vector<DataFile> files;
  std::map<std::string, std::size_t> known;
  for (gallery::GalleryEntry& entry : entries)
    for (gallery::GalleryDownload& download : entry.downloads) {
      if (!is_shared(download)) continue;
      const fs::path path = fs::path(out) / entry.folder / download.file;
      const std::string content = download.file + " " + hash::hash_of(io::read_file(path.string()));
      const auto [place, is_first] = known.try_emplace(content, files.size());
      if (is_first)
        files.push_back({path, &entry, {}});
      else
        fs::remove(path);
      files[place->second].downloads.push_back(&download);
    }
  return files;
}

void pack(DataFile& file) {
  if (file.downloads.front()->bytes < packed_from) return;
  const std::string packed = mat::gzip_packed(io::read_file(file.path.string()));
  io::write_file(file.path.string() + ".gz", packed);
  fs::remove(file.path);
  for (gallery::GalleryDownload* download : file.downloads) {
    download->file += ".gz";
    download->bytes = packed.size();
  }
}

}  // namespace

void pack_data(const std::string& out, std::vector<gallery::GalleryEntry>& entries) {
  std::vector<DataFile> files = different_files(out, entries);
  parallel::in_parallel(files.size(), 0, [&](std::size_t i) { pack(files[i]); });
  for (DataFile& file : files)
    for (gallery::GalleryDownload* download : file.downloads) {
      if (download == file.downloads.front()) continue;
      download->folder = file.keeper->folder;
      download->label = file.keeper->label;
    }
}

}  // namespace stepwire::thesis
