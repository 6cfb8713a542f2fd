#include <algorithm>
#include <filesystem>

#include "engine/app/studio/calls.hpp"
#include "engine/app/studio/gallery.hpp"

namespace stepwire::studio {

using json::Json;

namespace {

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

void add_gallery_calls(Calls& calls, Desk& desk) {
  calls["gallery"] = {[](int, const Arguments&) { return entries(); }, CallRow::Where::slow};
  calls["gallery.copy"] = {[&desk](int, const Arguments& arguments) { return copy(desk, arguments); }};
}

}  // namespace stepwire::studio
