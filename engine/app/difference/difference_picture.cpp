#include "engine/app/difference/difference_picture.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/app/difference/difference_text.hpp"
#include "engine/view/drawing/draw.hpp"

namespace stepwire::difference {
namespace {

using json::Json;

Json graph_of(const Registry& registry, const std::string& file) {
  diagram::Loader loader(registry);
  return drawing::DrawnFile(loader, file).view().graph({});
}

/// Returns the differences of the files themselves; nullptr if only parts differ.
const FileDifference* own_changes(const Difference& difference, const std::string& after) {
  const auto found = std::ranges::find(difference.files, after, &FileDifference::after);
  return found == difference.files.end() ? nullptr : &*found;
}

/// Calls a function with the name and the file of each part that a file uses. Does nothing for a file that
/// cannot be read.
template <class Use>
void each_part(Texts& texts, const std::string& file, Use use) {
  const DiagramText* text = texts.find(file);
  const yaml::Node* blocks = text ? text->document.root.find("blocks") : nullptr;
  for (std::size_t i = 0; blocks && i < blocks->entries.size(); ++i) {
    const yaml::Entry& block = blocks->entries[i];
    const yaml::Node* path = block.value.is_map() ? block.value.find("diagram") : nullptr;
    if (path) use(block.key, texts.part_path(file, path->text));
  }
}

/// True where a part differs, or a part within it. `seen` are the files that were looked at before.
bool has_changed(const Difference& difference, Texts& texts, const std::string& file,
                 std::set<std::string>& seen) {
  if (!seen.insert(file).second) return false;
  if (own_changes(difference, file)) return true;
  bool found = false;
  each_part(texts, file, [&](const std::string&, const std::string& part) {
    found = found || has_changed(difference, texts, part, seen);
  });
  return found;
}

/// Returns the names of the parts of a file that differ, or that use a part that differs.
std::vector<std::string> changed_parts(const Difference& difference, const std::string& file) {
  Texts texts;
  std::vector<std::string> names;
  each_part(texts, file, [&](const std::string& name, const std::string& part) {
    std::set<std::string> seen;
    if (has_changed(difference, texts, part, seen)) names.push_back(name);
  });
  return names;
}

/// Returns the names of the blocks that use parameters whose values changed, also by way of others.
std::vector<std::string> users_of_parameters(const Registry& registry, const FileDifference& own) {
  std::set<std::string> names;
  for (const Change& change : own.changes)
    if (change.section == "parameters" && change.kind == Change::Kind::changed) names.insert(change.name);
  Texts texts;
  const FileFacts facts = FactReader(registry, texts).read(own.after);
  const auto uses_one = [&](const Fact& fact) {
    return std::ranges::any_of(names_in(fact.canonical, NameKind::parameter),
                               [&](const std::string& name) { return names.contains(name); });
  };
  const Fact* parameters = facts.root.find("parameters");
  for (std::size_t count = 0; parameters && count != names.size();) {
    count = names.size();
    for (const Fact& one : parameters->parts)
      if (uses_one(one)) names.insert(unmarked(one.key));
  }
  std::vector<std::string> users;
  const Fact* blocks = facts.root.find("blocks");
  for (std::size_t i = 0; blocks && i < blocks->parts.size(); ++i)
    if (uses_one(blocks->parts[i])) users.push_back(unmarked(blocks->parts[i].key));
  return users;
}

/// Returns a line for each change, and a heading above those of a part. Lines of what the drawing does not
/// show begin with their section.
Json lines_of(const Difference& difference, const std::string& drawn_file) {
  Json lines = Json::list();
  for (const FileDifference& file : difference.files) {
    if (file.after != drawn_file)
      lines.push(Json::object().set("heading",
                                    "in the part " + std::filesystem::path(file.after).filename().string()));
    for (const Change& change : file.changes) {
      const bool is_drawn =
          change.section == "blocks" || change.section == "wires" || change.section == "values";
      std::string line = line_of(change);
      if (!is_drawn) line.insert(2, change.section + " ");
      lines.push(std::move(line));
    }
  }
  return lines;
}

}  // namespace

std::string difference_picture(const Registry& registry, const std::string& before, const std::string& after,
                               const Difference& difference) {
  Json names = Json::object();
  std::vector<std::string> changed = changed_parts(difference, after);
  const FileDifference* own = own_changes(difference, after);
  if (own)
    for (std::string& name : users_of_parameters(registry, *own)) changed.push_back(std::move(name));
  for (std::size_t i = 0; own && i < own->changes.size(); ++i) {
    const Change& change = own->changes[i];
    const bool is_block = change.section == "blocks" || change.section == "values";
    if (is_block && change.kind == Change::Kind::renamed) names.set(change.from, change.to);
    if (is_block && change.kind == Change::Kind::changed) changed.push_back(change.name);
  }
  Json compared = Json::object();
  compared.set("before", graph_of(registry, before)).set("after", graph_of(registry, after));
  compared.set("names", std::move(names)).set("changed", Json::list_of(changed));
  compared.set("lines", lines_of(difference, after));
  return drawing::draw_picture(Json::object().set("compared", std::move(compared)));
}

}  // namespace stepwire::difference
