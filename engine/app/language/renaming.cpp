#include "engine/app/language/renaming.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "engine/base/text/characters.hpp"
#include "engine/model/diagram/keys.hpp"

namespace stepwire::language {

namespace {

using MeaningKind = Meaning::Kind;

/// True if the name is already used in the same scope.
bool is_taken(const yaml::Document& document, MeaningKind kind, const std::string& name) {
  const auto has = [&](const char* section) {
    return DiagramFiles::entry(document, section, name) != nullptr;
  };
  if (kind == MeaningKind::parameter) return has("parameters") || has("inputs");
  if (kind == MeaningKind::output) return has("outputs");
  return has("blocks") || has("inputs") || (kind == MeaningKind::input && has("parameters"));
}

void check_name(DiagramFiles& files, const Meaning& meaning, const std::string& name) {
  const bool is_good =
      meaning.kind == MeaningKind::block ? diagram::is_dotted_name(name) : diagram::is_name(name);
  if (!is_good || name == "time" || name == "all")
    throw EditRefused(fmt::format("'{}' is no name; use letters, digits and '_', not beginning with a digit",
                                  text::visible(name)));
  const auto document = files.tree(meaning.file);
  if (document && is_taken(*document, meaning.kind, name))
    throw EditRefused(fmt::format("there is a '{}' already", name));
}

/// True if the file defines the name or mentions the file that does.
bool concerns(const std::string& file, const std::string& text, const Meaning& meaning) {
  const std::string name = std::filesystem::path(meaning.file).filename().string();
  return file == meaning.file || text.find(name) != std::string::npos;
}

/// Throws if an open file that may contain the name is currently invalid YAML.
void check_readable(DiagramFiles& files, const Meaning& meaning) {
  for (const std::string& file : files.texts().open_paths()) {
    if (!concerns(file, *files.texts().text(file), meaning)) continue;
    try {
      files.texts().document(file);
    } catch (const yaml::Error& error) {
      throw EditRefused(fmt::format("mend this file first, which may have the name: {}", error.what()));
    }
  }
}

/// Throws if renaming adds faults to a valid file, which would mean that a use was missed.
void check_result(DiagramFiles& files, const std::map<std::string, std::string>& texts) {
  DiagramFiles after(files.registry());
  after.texts() = files.texts();
  for (const auto& [file, text] : texts) after.texts().open(file, text);
  for (const auto& [file, text] : texts) {
    const Analysis now = analyse(after, file);
    if (now.faults.empty() || !analyse(files, file).faults.empty()) continue;
    throw EditRefused("with that name a file would have a fault: " + now.faults.front().text());
  }
}

}  // namespace

NamePiece renamed_piece(DiagramFiles& files, const std::string& file, std::size_t offset) {
  const auto piece = files.piece_at(file, offset);
  if (!piece) throw EditRefused("no name of the diagram stands here");
  if (piece->meaning.kind == MeaningKind::port)
    throw EditRefused("this name is declared by the kind of the block; it cannot be changed in a file");
  return *piece;
}

FileSplices rename(DiagramFiles& files, const std::string& file, std::size_t offset,
                   const std::string& name) {
  const Meaning meaning = renamed_piece(files, file, offset).meaning;
  if (meaning.name == name) return {};
  check_name(files, meaning, name);
  check_readable(files, meaning);
  FileSplices splices;
  for (const FilePlace& place : files.references(meaning)) splices[place.file].push_back({place.range, name});
  std::map<std::string, std::string> texts;
  for (const auto& [path, changes] : splices)
    texts[path] = spliced_values(*files.texts().text(path), changes);
  check_result(files, texts);
  return splices;
}

}  // namespace stepwire::language
