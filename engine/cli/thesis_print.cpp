#include "engine/cli/thesis_print.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <thread>

#include "engine/process/filter.hpp"
#include "engine/table/cache.hpp"
#include "engine/table/file.hpp"

namespace stepwire {

namespace {

constexpr const char* printer = "rsvg-convert";

/// What a former call has made of the same pictures; nothing where there is none or it is not whole.
std::optional<std::string> kept_print(const std::string& path) {
  try {
    std::string text = read_file(path);
    if (text.starts_with("%PDF") && text.ends_with("%%EOF\n")) return text;
  } catch (const SurroundingsError&) {
  }
  return std::nullopt;
}

void keep_print(const std::string& path, const std::string& text) {
  try {
    write_file(path, text);
  } catch (const SurroundingsError&) {
  }
}

std::string printed(const std::string& program, const std::vector<std::string>& files) {
  std::uint64_t hash = hash_of(printer);
  for (const std::string& file : files) hash = hash_of(read_file(file), hash);
  const std::string path = fmt::format("{}/{:016x}.pdf", cache_folder(), hash);
  if (std::optional<std::string> text = kept_print(path)) return *std::move(text);
  std::vector<std::string> arguments{"--format=pdf"};
  arguments.insert(arguments.end(), files.begin(), files.end());
  FilterAnswer answer = run_filter(program, arguments, "");
  if (answer.status != 0) throw SurroundingsError(fmt::format("{}: {}", printer, answer.complaints));
  keep_print(path, answer.output);
  return answer.output;
}

/// The entries of one chapter, and their pictures.
struct Chapter {
  std::string file;
  std::vector<GalleryEntry*> entries;
  std::vector<std::string> pictures;

  void add(const std::string& out, GalleryEntry& entry) {
    entry.print = {file, pictures.size() + 1};
    entries.push_back(&entry);
    for (const GalleryPicture& picture : entry.pictures)
      pictures.push_back(fmt::format("{}/{}/{}", out, entry.folder, picture.file));
  }

  void leave_out(const std::string& note) {
    for (GalleryEntry* entry : entries) {
      entry->print = {};
      entry->note = note;
    }
  }

  void print(const std::string& program, const std::string& out) {
    if (program.empty())
      return leave_out(fmt::format(
          "There is no PDF, since {} is not installed; on Debian it is the package librsvg2-bin.", printer));
    try {
      write_file(out + "/" + file, printed(program, pictures));
    } catch (const SurroundingsError& error) {
      leave_out(fmt::format("There is no PDF: {}", error.what()));
    }
  }
};

/// A chapter is whatever a diagram file calls it.
std::string print_name(const std::string& chapter) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0; };
  if (chapter.empty() || !std::ranges::all_of(chapter, plain)) return "pictures.pdf";
  return "chapter-" + chapter + ".pdf";
}

}  // namespace

void print_chapters(const std::string& out, std::vector<GalleryEntry>& entries) {
  std::map<std::string, Chapter> chapters;
  for (GalleryEntry& entry : entries) {
    if (entry.pictures.empty()) continue;
    const std::string name = print_name(chapter_of(entry));
    Chapter& chapter = chapters[name];
    chapter.file = name;
    chapter.add(out, entry);
  }
  const std::string program = find_program(printer);
  std::vector<std::jthread> threads;
  for (auto& [name, chapter] : chapters)
    threads.emplace_back([&chapter = chapter, &program, &out] { chapter.print(program, out); });
}

}  // namespace stepwire
