#include <fmt/format.h>

#include <optional>

#include "engine/cli/thesis_entry.hpp"
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
    if (text.starts_with("%PDF") && text.find("%%EOF", text.size() < 16 ? 0 : text.size() - 16) != text.npos)
      return text;
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

}  // namespace

void print_pictures(const std::string& out, GalleryEntry& entry) {
  if (entry.pictures.empty()) return;
  const std::string program = find_program(printer);
  if (program.empty()) {
    entry.note = fmt::format(
        "There is no PDF, since {} is not installed; on Debian it is the package librsvg2-bin.", printer);
    return;
  }
  std::vector<std::string> files;
  for (const GalleryPicture& picture : entry.pictures)
    files.push_back(fmt::format("{}/{}/{}", out, entry.folder, picture.file));
  write_file(fmt::format("{}/{}/pictures.pdf", out, entry.folder), printed(program, files));
}

}  // namespace stepwire
