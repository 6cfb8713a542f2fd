#include "engine/app/thesis/thesis_data.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/base/io/file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::thesis {
namespace {

namespace fs = std::filesystem;

/// A gallery whose entries have one CSV file each, with a number of bytes of one letter.
struct Gallery {
  Scratch scratch;
  std::string out = scratch.path("gallery");
  std::vector<gallery::GalleryEntry> entries;

  void add(const std::string& folder, const std::string& file, std::size_t bytes, char letter) {
    fs::create_directories(fs::path(out) / folder);
    io::write_file(path(folder, file), std::string(bytes, letter));
    gallery::GalleryEntry entry;
    entry.folder = folder;
    entry.label = "Figure " + folder;
    entry.downloads.push_back({file, bytes});
    entries.push_back(entry);
  }
  std::string path(const std::string& folder, const std::string& file) const {
    return out + "/" + folder + "/" + file;
  }
  const gallery::GalleryDownload& download(std::size_t entry) const {
    return entries[entry].downloads.front();
  }
};

}  // namespace

TEST_CASE(
    "data that several entries have are kept once, by the first of them, and packed where they are large") {
  Gallery gallery;
  gallery.add("1", "trials.csv", 600'000, 'a');
  gallery.add("2", "trials.csv", 600'000, 'a');
  gallery.add("3", "trials.csv", 600'000, 'b');
  pack_data(gallery.out, gallery.entries);
  for (const std::string folder : {"1", "2", "3"})
    CHECK_FALSE(fs::exists(gallery.path(folder, "trials.csv")));
  CHECK(fs::exists(gallery.path("1", "trials.csv.gz")));
  CHECK_FALSE(fs::exists(gallery.path("2", "trials.csv.gz")));
  CHECK(fs::exists(gallery.path("3", "trials.csv.gz")));
  for (std::size_t entry = 0; entry < 3; ++entry) {
    const gallery::GalleryDownload& download = gallery.download(entry);
    CHECK(download.file == "trials.csv.gz");
    CHECK(download.folder == (entry == 1 ? "1" : ""));
    CHECK(download.label == (entry == 1 ? "Figure 1" : ""));
    const std::string folder = download.folder.empty() ? gallery.entries[entry].folder : download.folder;
    CHECK(download.bytes == fs::file_size(gallery.path(folder, download.file)));
  }
}

TEST_CASE("data of the same numbers under another name, and small ones, stay where they are") {
  Gallery gallery;
  gallery.add("1", "trials.csv", 100'000, 'a');
  gallery.add("2", "errors.csv", 100'000, 'a');
  gallery.add("3", "means.csv", 1'000, 'a');
  gallery.add("4", "means.csv", 1'000, 'a');
  pack_data(gallery.out, gallery.entries);
  for (std::size_t entry = 0; entry < 4; ++entry) {
    const gallery::GalleryDownload& download = gallery.download(entry);
    CHECK(download.folder == "");
    CHECK(fs::file_size(gallery.path(gallery.entries[entry].folder, download.file)) == download.bytes);
  }
}

}  // namespace stepwire::thesis
