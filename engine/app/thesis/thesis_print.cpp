#include "engine/app/thesis/thesis_print.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/cache.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/view/gallery/gallery_print.hpp"
#include "engine/view/render/pdf_outline.hpp"

namespace stepwire::thesis {

namespace {

constexpr const char* printer = "rsvg-convert";

/// Converts SVG pages to one PDF, or loads it from the cache.
std::string printed(const std::string& program, const std::vector<std::string>& pages) {
  hash::Hash hash;
  hash.add(printer);
  for (const std::string& page : pages) hash.add(page);
  const io::Cache cache;
  const std::string name = hash.text() + ".pdf";
  if (std::optional<std::string> text = cache.find(name)) return *std::move(text);
  const subprocess::ScratchFolder folder;
  // Fixes the creation time in the PDF, so that equal pages give equal bytes.
  subprocess::ProcessCall call{.command = {"env", "SOURCE_DATE_EPOCH=0", program, "--format=pdf"}};
  for (std::size_t i = 0; i < pages.size(); ++i) {
    call.command.push_back(folder.path() + "/" + io::numbered("page", i, ".svg"));
    io::write_file(call.command.back(), pages[i]);
  }
  const subprocess::ProcessResult answer = subprocess::run_helper(printer, call);
  cache.keep(name, answer.output);
  return answer.output;
}

/// The entries of one chapter, and the pages of their pictures.
struct Chapter {
  std::string file;
  std::vector<gallery::GalleryEntry*> entries;
  std::vector<std::string> pages;  ///< SVG pages
  std::vector<render::Bookmark> bookmarks;

  void add(const std::string& out, gallery::GalleryEntry& entry) {
    entry.print = {file, pages.size() + 1};
    entries.push_back(&entry);
    bookmarks.push_back({gallery::printed_name(entry), entry.print.page});
    for (const gallery::GalleryPicture& picture : entry.pictures)
      pages.push_back(gallery::printed_page(
          entry, picture, io::read_file(fmt::format("{}/{}/{}", out, entry.folder, picture.file))));
  }

  void leave_out(const std::string& note) {
    for (gallery::GalleryEntry* entry : entries) {
      entry->print = {};
      entry->note = note;
    }
  }

  void print(const std::string& program, const std::string& out) {
    if (program.empty())
      return leave_out(fmt::format(
          "There is no PDF, since {} is not installed; on Debian it is the package librsvg2-bin.", printer));
    try {
      io::write_file(out + "/" + file, render::with_outline(printed(program, pages), bookmarks));
    } catch (const std::exception& error) {  // also after an interruption of the printer
      leave_out(fmt::format("There is no PDF: {}", error.what()));
    }
  }
};

/// Returns the file name of a chapter. The chapter is free text in the diagram file, so other names than
/// letters and digits share one file.
std::string print_name(const std::string& chapter) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0; };
  if (chapter.empty() || !std::ranges::all_of(chapter, plain)) return "pictures.pdf";
  return "chapter-" + chapter + ".pdf";
}

}  // namespace

void print_chapters(const std::string& out, std::vector<gallery::GalleryEntry>& entries) {
  std::map<std::string, Chapter> chapters;
  for (gallery::GalleryEntry& entry : entries) {
    if (entry.pictures.empty()) continue;
    const std::string name = print_name(gallery::chapter_of(entry));
    Chapter& chapter = chapters[name];
    chapter.file = name;
    chapter.add(out, entry);
  }
  const std::string program = subprocess::find_program(printer);
  std::vector<Chapter*> all;
  for (auto& [name, chapter] : chapters) all.push_back(&chapter);
  parallel::in_parallel(all.size(), 0, [&](std::size_t i) { all[i]->print(program, out); });
}

}  // namespace stepwire::thesis
