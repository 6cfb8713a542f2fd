#include "engine/app/studio/gallery.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "blocks/register.hpp"
#include "engine/app/studio/diagram_files.hpp"
#include "engine/app/studio/fault.hpp"
#include "engine/app/studio/named_files.hpp"
#include "engine/base/io/file.hpp"
#include "tests/engine/app/cli/program.hpp"

namespace stepwire::studio {

namespace {

namespace fs = std::filesystem;

std::vector<CopiedFile> write_copy(const std::string& diagram, const Scratch& folder,
                                   const std::string& name) {
  std::vector<CopiedFile> files = copies_of(diagram, folder.path(name));
  for (const CopiedFile& file : files) io::write_file(file.path, file.text);
  return files;
}

std::string copied(const std::string& diagram, const Scratch& folder, const std::string& name) {
  return write_copy(diagram, folder, name).front().path;
}

bool lies_in(const std::string& path, const Scratch& folder) {
  return path.starts_with(folder.path("")) || (!data_folder().empty() && path.starts_with(data_folder()));
}

}  // namespace

TEST_CASE("the gallery holds the examples and the figures of the thesis with their titles") {
  const std::vector<GalleryEntry> entries = gallery();
  const auto count = [&](const std::string& group) {
    return std::ranges::count(entries, group, &GalleryEntry::group);
  };
  CHECK(count("examples") > 50);
  CHECK(count("thesis") > 45);
  for (const GalleryEntry& entry : entries) {
    INFO(entry.name);
    CHECK_FALSE(entry.title.empty());
    CHECK(entry.caption.find('\n') == std::string::npos);
  }
}

TEST_CASE("a copy of any entry of the gallery names nothing outside of its own folder") {
  const Scratch folder;
  for (const GalleryEntry& entry : gallery()) {
    INFO(entry.path);
    const std::vector<CopiedFile> written = write_copy(entry.path, folder, entry.name + ".yaml");
    DiagramFiles files(written.front().path, DraftStore(""));
    const auto documents = files.documents(written.front().path);
    const auto diagrams =
        std::ranges::count_if(written, [](const CopiedFile& it) { return it.path.ends_with(".yaml"); });
    CHECK(std::ssize(documents) == diagrams);
    for (const yaml::Document& document : documents)
      for (const NamedFile& named : named_files(document)) {
        INFO(named.path);
        CHECK(lies_in(named.path, folder));
      }
  }
}

TEST_CASE("the data folder is one folder however its path is written") {
  const Scratch folder;
  io::write_file(folder.path("data/record.csv"), "t\n0\n");
  const std::string before = data_folder();
  ::setenv("STEPWIRE_DATA", folder.path("else/../data").c_str(), 1);
  const std::string named = data_folder();
  before.empty() ? ::unsetenv("STEPWIRE_DATA") : ::setenv("STEPWIRE_DATA", before.c_str(), 1);
  CHECK(named == fs::canonical(folder.path("data")).string());
}

TEST_CASE("copies load, with parts in parts, with parts of one name, and beside each other") {
  const Registry registry = blocks();
  const Scratch folder;
  const auto entries = gallery();
  for (const std::string& name :
       std::vector<std::string>{"72-figure-of-eight", "11-parts-in-parts", "10-a-part"}) {
    const auto entry = std::ranges::find(entries, name, &GalleryEntry::name);
    REQUIRE(entry != entries.end());
    CHECK_NOTHROW(diagram::Loader(registry).load(copied(entry->path, folder, name + ".yaml")));
  }
  const std::string part = "stepwire: 1\noutputs: {y: one}\nblocks:\n  one: {block: Constant, value: 1}\n";
  io::write_file(folder.path("from/a/part.yaml"), part);
  io::write_file(folder.path("from/b/part.yaml"), part + "  two: {block: Constant, value: 2}\n");
  io::write_file(folder.path("from/top.yaml"),
                 "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n  a: {diagram: a/part.yaml}\n"
                 "  b: {diagram: \"b/part.yaml\"}\n  c: {diagram: a/part.yaml}\nrecord: [a.y, b.y, c.y]\n");
  const auto files = copies_of(folder.path("from/top.yaml"), folder.path("to/top.yaml"));
  CHECK(files.size() == 3);
  const std::string copy = copied(folder.path("from/top.yaml"), folder, "to/top.yaml");
  CHECK(diagram::Loader(registry).load(copy).blocks.size() == 4);
}

}  // namespace stepwire::studio
