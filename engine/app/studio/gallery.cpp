#include "engine/app/studio/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "engine/app/studio/calls.hpp"
#include "engine/app/studio/named_files.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/resources.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::studio {

using json::Json;

namespace {

namespace fs = std::filesystem;

std::string text_under(const yaml::Node& root, const char* key) {
  const yaml::Node* value = root.find(key);
  return value && value->is_scalar() ? value->text : "";
}

std::string on_one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

void add_entries(const fs::path& folder, std::vector<GalleryEntry>& entries) {
  std::error_code none;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, none)) {
    if (file.path().extension() != ".yaml") continue;
    const yaml::Document document = yaml::read_document(file.path().string());
    entries.push_back({file.path().string(), file.path().stem().string(), text_under(document.root, "title"),
                       on_one_line(text_under(document.root, "caption")), folder.filename().string()});
  }
}

/// Returns the byte offset of a mark.
std::size_t position(std::string_view text, const yaml::Mark& mark) {
  std::size_t at = 0;
  for (int line = 1; line < mark.line && at < text.size(); ++line)
    at = std::min(text.find('\n', at), text.size()) + 1;
  for (int column = 1; column < mark.column && at < text.size(); ++column)
    at += std::max<std::size_t>(1, text::utf8_length(text.substr(at)));
  return at;
}

/// Collects the files of one copy.
class Copy {
 public:
  /// `parts` is the folder for all files except the first one.
  explicit Copy(fs::path parts) : parts_(std::move(parts)) {}

  void add(const std::string& from, const fs::path& to) {
    const std::size_t place = files_.size();
    files_.push_back({to.string(), io::read_file(from)});
    if (to.extension() != ".yaml") return;
    std::string text = renamed(files_[place].text, from, to.parent_path());
    files_[place].text = std::move(text);
  }

  std::vector<CopiedFile> take() { return std::move(files_); }

 private:
  /// Returns the text with the names of the copies in place of the original names. Names of files in the data
  /// folder are unchanged, as they hold everywhere.
  std::string renamed(std::string text, const std::string& from, const fs::path& folder) {
    std::map<std::size_t, const NamedFile*, std::greater<>> places;
    const std::vector<NamedFile> all = named_files(yaml::parse_document(text, from));
    for (const NamedFile& one : all)
      if (!one.word.starts_with("data/")) places[text.find(one.word, position(text, one.mark))] = &one;
    for (const auto& [at, one] : places)
      if (at != std::string::npos)
        text.replace(at, one->word.size(), copied(one->path).lexically_relative(folder).generic_string());
    return text;
  }

  /// Returns the path of a file's copy; the first call copies the file.
  fs::path copied(const fs::path& from) {
    if (const auto known = known_.find(from); known != known_.end()) return known->second;
    fs::path to = parts_ / from.filename();
    for (int i = 2; taken_.contains(to); ++i)
      to = parts_ / fmt::format("{}-{}{}", from.stem().string(), i, from.extension().string());
    taken_.insert(to);
    known_[from] = to;
    add(from.string(), to);
    return to;
  }

  fs::path parts_;
  std::map<fs::path, fs::path> known_;
  std::set<fs::path> taken_;
  std::vector<CopiedFile> files_;
};

Json entries() {
  Json list = Json::list();
  const std::vector<GalleryEntry> all = gallery();
  for (std::size_t i = 0; i < all.size(); ++i)
    list.push(Json::object()
                  .set("entry", i)
                  .set("name", all[i].name)
                  .set("title", all[i].title)
                  .set("caption", all[i].caption)
                  .set("group", all[i].group));
  return Json::object().set("entries", std::move(list));
}

/// Returns a plain file name with the ending .yaml; throws Fault for folders, hidden files and names like
/// options.
std::string file_name(std::string name) {
  if (name.ends_with(".yaml")) name.resize(name.size() - 5);
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_ ";
  const bool is_plain =
      !name.empty() && name.size() <= 100 && name.find_first_not_of(letters) == std::string::npos;
  if (!is_plain || name.starts_with('-') || name.starts_with(' '))
    throw Fault(
        "this is no name of a file; it has letters, digits, '-', '_' and spaces, and does not begin with '-' "
        "or a space");
  return name + ".yaml";
}

Json copy(Desk& desk, const Arguments& arguments) {
  const std::vector<GalleryEntry> all = gallery();
  const auto entry = static_cast<std::size_t>(arguments.whole("entry"));
  if (entry >= all.size()) throw Fault("the gallery has no such entry");
  const std::string name = file_name(arguments.text("name"));
  const std::lock_guard lock(desk.mutex);
  const std::filesystem::path folder = std::filesystem::path(desk.files.path(0)).parent_path();
  // Parts are created before the diagram that names them, so that a diagram that exists is complete.
  std::vector<CopiedFile> files = copies_of(all[entry].path, (folder / name).string());
  std::ranges::reverse(files);
  if (std::filesystem::exists(files.back().path)) throw Fault("there is a file of this name already");
  for (const CopiedFile& file : files) desk.files.beneath().create(file.path, file.text);
  return Json::object().set("file", desk.files.number(files.back().path));
}

}  // namespace

std::vector<GalleryEntry> gallery() {
  std::vector<GalleryEntry> entries;
  const std::string diagrams = io::find_resource("diagrams");
  if (diagrams.empty()) return entries;
  for (const char* group : {"examples", "thesis"}) add_entries(fs::path(diagrams) / group, entries);
  std::ranges::sort(entries, {}, [](const GalleryEntry& one) { return std::pair(one.group, one.name); });
  return entries;
}

std::vector<CopiedFile> copies_of(const std::string& diagram, const std::string& file) {
  const fs::path to(file);
  Copy copy(to.parent_path() / (to.stem().string() + "-parts"));
  copy.add(diagram, to);
  return copy.take();
}

void add_gallery_calls(Calls& calls, Desk& desk) {
  calls["gallery"] = {[](int, const Arguments&) { return entries(); }, CallRow::Where::slow};
  calls["gallery.copy"] = {[&desk](int, const Arguments& arguments) { return copy(desk, arguments); }};
}

}  // namespace stepwire::studio
