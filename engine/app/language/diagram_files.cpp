#include "engine/app/language/diagram_files.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/uses.hpp"

namespace stepwire::language {

namespace fs = std::filesystem;
using Sense = WrittenName::Sense;

namespace {

constexpr std::size_t most_files = 2000;
constexpr int deepest_folder = 8;

std::string beside(const std::string& user, const std::string& path) {
  return (fs::path(user).parent_path() / path).lexically_normal().string();
}

bool is_diagram_file(const fs::path& path) {
  return path.extension() == ".yaml" || path.extension() == ".yml";
}

void add_files_below(const std::string& folder, std::set<std::string>& files) {
  std::error_code none;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, none), end;
  for (; !none && at != end && files.size() < most_files; at.increment(none)) {
    const std::string name = at->path().filename().string();
    if (at->is_directory(none) &&
        (name.starts_with('.') || name == "node_modules" || at.depth() >= deepest_folder))
      at.disable_recursion_pending();
    else if (is_diagram_file(at->path()) && at->is_regular_file(none))
      files.insert(at->path().lexically_normal().string());
  }
}

/// Returns the first piece of a name, up to its first dot.
std::string_view first_piece(std::string_view name) {
  return name.substr(0, name.find('.'));
}

}  // namespace

Forms& DiagramFiles::forms(const std::string& file) {
  forms_.look_for_parts([this, file](const std::string& path) { return tree(path_of_part(file, path)); });
  return forms_;
}

const yaml::Entry* DiagramFiles::entry(const yaml::Document& document, const char* section,
                                       const std::string& name) {
  const yaml::Node* map = document.root.find(section);
  if (!map) return nullptr;
  const auto found = std::ranges::find(map->entries, name, &yaml::Entry::key);
  return found == map->entries.end() ? nullptr : &*found;
}

std::string DiagramFiles::path_of_part(const std::string& user, const std::string& path) {
  const auto document = tree(user);
  const auto use = document ? diagram::use_of(document->root, path) : std::nullopt;
  return use ? diagram::fetched_file(*use, path) : beside(user, path);
}

std::string DiagramFiles::part_file(const std::string& user, const yaml::Entry& block) {
  const yaml::Node* path =
      block.value.is_map() && !block.value.find("block") ? block.value.find("diagram") : nullptr;
  return path && path->is_scalar() ? path_of_part(user, path->text) : "";
}

const yaml::Entry* DiagramFiles::block_at_start(const yaml::Document& document, std::string_view reference) {
  const yaml::Node* blocks = document.root.find("blocks");
  const yaml::Entry* longest = nullptr;
  if (!blocks) return nullptr;
  for (const yaml::Entry& entry : blocks->entries) {
    const bool starts =
        reference == entry.key || (reference.starts_with(entry.key) && reference[entry.key.size()] == '.');
    if (starts && (!longest || longest->key.size() < entry.key.size())) longest = &entry;
  }
  return longest;
}

const yaml::Entry* DiagramFiles::indexed(const std::shared_ptr<const yaml::Document>& document,
                                         const char* section, std::string_view name) {
  constexpr std::size_t most_indices = 64;  // beyond, those of former texts are dropped
  const auto known = indices_.find({document, section});
  if (known == indices_.end() && indices_.size() >= most_indices) indices_.clear();
  Index& index = known == indices_.end() ? indices_[{document, section}] : known->second;
  const yaml::Node* map = known == indices_.end() ? document->root.find(section) : nullptr;
  for (std::size_t i = 0; map && i < map->entries.size(); ++i)
    index.emplace(map->entries[i].key, &map->entries[i]);
  const auto found = index.find(name);
  return found == index.end() ? nullptr : found->second;
}

const yaml::Entry* DiagramFiles::indexed_block(const std::shared_ptr<const yaml::Document>& document,
                                               std::string_view reference) {
  for (std::size_t end = reference.size(); end != std::string_view::npos && end > 0;
       end = reference.rfind('.', end - 1))
    if (const yaml::Entry* found = indexed(document, "blocks", reference.substr(0, end))) return found;
  return nullptr;
}

bool DiagramFiles::has_one_output(const std::string& file, const yaml::Entry& block) {
  const yaml::Node* kind = block.value.is_map() ? block.value.find("block") : nullptr;
  const BlockType* type = kind ? registry_.find(kind->text) : nullptr;
  return type ? diagram::has_one_output(*type) : outputs(file, block).size() == 1;
}

std::vector<std::string> DiagramFiles::outputs(const std::string& file, const yaml::Entry& block) {
  std::vector<std::string> names;
  if (const std::string path = part_file(file, block); !path.empty()) {
    const auto part = tree(path);
    const yaml::Node* outputs = part ? part->root.find("outputs") : nullptr;
    for (std::size_t i = 0; outputs && i < outputs->entries.size(); ++i)
      names.push_back(outputs->entries[i].key);
    return names;
  }
  const yaml::Node* kind = block.value.is_map() ? block.value.find("block") : nullptr;
  const BlockType* type = kind ? registry_.find(kind->text) : nullptr;
  for (std::size_t i = 0; type && i < type->outputs.size(); ++i) names.push_back(type->outputs[i].name);
  return names;
}

const std::vector<WrittenName>& DiagramFiles::names(const std::string& file) {
  NamesOf& known = names_[file];
  std::shared_ptr<const yaml::Document> now;
  try {
    now = texts_.document(file);
  } catch (const yaml::Error&) {
    return (known = {}).names;
  }
  // The names are always recomputed, since a changed part may give the keys of its users another meaning.
  // This is cheap.
  known = {now, written_names(*now, *texts_.text(file), forms(file))};
  return known.names;
}

const WrittenName* DiagramFiles::name_at(const std::string& file, std::size_t offset) {
  for (const WrittenName& name : names(file))
    if (name.range.contains(offset)) return &name;
  return nullptr;
}

void DiagramFiles::add_parameter(const std::string& file, TextRange range, std::string_view name,
                                 std::vector<NamePiece>& found) {
  const auto document = tree(file);
  if (document && indexed(document, "parameters", name))
    found.push_back({range, {file, Meaning::Kind::parameter, std::string(name)}});
}

/// Resolves a dotted name of a signal from left to right and appends its pieces.
/// Problem: names of blocks can contain dots, and a name can lead through parts into other files. Idea: each
/// step takes the longest block whose name is a prefix. If that is a part, the rest is resolved in the part's
/// file.
/// Within a part, outputs hide inputs and blocks, unless `blocks_first`. The depth is limited, because files
/// under edit can use each other in a cycle.
void DiagramFiles::add_signal(const std::string& file, TextRange rest, std::string_view name,
                              std::vector<NamePiece>& found, bool blocks_first, int depth) {
  const auto document = tree(file);
  if (!document || name.empty() || depth > 32) return;
  const std::string first(first_piece(name));
  const TextRange first_range{rest.from, rest.from + first.size()};
  const yaml::Entry* block = indexed_block(document, name);
  if (depth > 0 && !(blocks_first && block) && indexed(document, "outputs", first))
    return found.push_back({first_range, {file, Meaning::Kind::output, first}});
  if (indexed(document, "inputs", first))
    return found.push_back({first_range, {file, Meaning::Kind::input, first}});
  if (!block) return add_parameter(file, first_range, first, found);
  const std::size_t size = block->key.size();
  found.push_back({{rest.from, rest.from + size}, {file, Meaning::Kind::block, block->key}});
  if (name.size() <= size + 1) return;
  const std::string_view behind = name.substr(size + 1);
  const TextRange behind_range{rest.from + size + 1, rest.to};
  if (const std::string part = part_file(file, *block); !part.empty())
    return add_signal(part, behind_range, behind, found, blocks_first, depth + 1);
  const std::string port(first_piece(behind));
  found.push_back({{behind_range.from, behind_range.from + port.size()},
                   {file, Meaning::Kind::port, block->key + "." + port}});
}

std::optional<Meaning> DiagramFiles::key_of_part(const std::string& file, const WrittenName& name) {
  const auto document = tree(file);
  const yaml::Entry* block = document ? indexed(document, "blocks", name.block) : nullptr;
  const std::string path = block ? part_file(file, *block) : "";
  const auto part = path.empty() ? nullptr : tree(path);
  if (!part) return std::nullopt;
  const bool input = entry(*part, "inputs", name.name) != nullptr;
  return Meaning{path, input ? Meaning::Kind::input : Meaning::Kind::parameter, name.name};
}

std::optional<Meaning> DiagramFiles::meaning_of_key(const std::string& file, const WrittenName& name) {
  static const std::map<Sense, Meaning::Kind> defined{{Sense::block, Meaning::Kind::block},
                                                      {Sense::input, Meaning::Kind::input},
                                                      {Sense::output, Meaning::Kind::output},
                                                      {Sense::defined, Meaning::Kind::parameter}};
  if (const auto kind = defined.find(name.sense); kind != defined.end())
    return Meaning{file, kind->second, name.name};
  if (name.sense == Sense::part_key) return key_of_part(file, name);
  if (name.sense != Sense::block_key) return std::nullopt;
  return Meaning{file, Meaning::Kind::port, name.block + "." + name.name};
}

std::vector<NamePiece> DiagramFiles::pieces(const std::string& file, const WrittenName& name) {
  if (const auto meaning = meaning_of_key(file, name)) return {{name.range, *meaning}};
  std::vector<NamePiece> found;
  const bool dotted = name.name.find('.') != std::string::npos;
  if (name.sense == Sense::parameter && !dotted) add_parameter(file, name.range, name.name, found);
  if (name.sense == Sense::inside) add_signal(file, name.range, name.name, found, true);
  if (name.sense == Sense::signal || (name.sense == Sense::parameter && dotted))
    add_signal(file, name.range, name.name, found);
  return found;
}

std::optional<NamePiece> DiagramFiles::piece_at(const std::string& file, std::size_t offset) {
  const WrittenName* name = name_at(file, offset);
  if (!name) return std::nullopt;
  for (const NamePiece& piece : pieces(file, *name))
    if (piece.range.contains(offset)) return piece;
  return std::nullopt;
}

std::optional<FilePlace> DiagramFiles::definition(const Meaning& meaning) {
  const auto document = tree(meaning.file);
  if (!document) return std::nullopt;
  const char* section = meaning.kind == Meaning::Kind::parameter ? "parameters"
                        : meaning.kind == Meaning::Kind::input   ? "inputs"
                        : meaning.kind == Meaning::Kind::output  ? "outputs"
                                                                 : "blocks";
  const std::string name =
      meaning.kind == Meaning::Kind::port ? meaning.name.substr(0, meaning.name.rfind('.')) : meaning.name;
  const yaml::Entry* found = entry(*document, section, name);
  if (!found) return std::nullopt;
  const auto text = texts_.text(meaning.file);
  return FilePlace{meaning.file, TextPlaces(*text).key_range(*found)};
}

std::vector<FilePlace> DiagramFiles::references(const Meaning& meaning) {
  std::vector<FilePlace> places;
  for (const std::string& file : paths()) {
    const std::vector<WrittenName> all = names(file);  // copied, because resolving names reads other files
    for (const WrittenName& name : all)
      for (const NamePiece& piece : pieces(file, name))
        if (piece.meaning == meaning) places.push_back({file, piece.range});
  }
  std::ranges::sort(places);  // sorted, because the content of an alias occurs twice
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

std::vector<std::string> DiagramFiles::paths() {
  std::set<std::string> files;
  for (const std::string& path : texts_.open_paths()) files.insert(path);
  for (const std::string& folder : folders_) add_files_below(folder, files);
  if (folders_.empty())
    for (const std::string& path : texts_.open_paths())
      add_files_below(fs::path(path).parent_path().string(), files);
  return {files.begin(), files.end()};
}

}  // namespace stepwire::language
