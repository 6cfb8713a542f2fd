#include "engine/app/language/language_service.hpp"

#include <algorithm>

#include "engine/app/language/diagram_files.hpp"

namespace stepwire::language {
namespace {

constexpr int deepest_part = 32;
constexpr std::size_t most_shapes = 20'000;

class Shapes {
 public:
  explicit Shapes(DiagramFiles& files) : files_(files) {}

  void add_file(const std::string& file, const std::string& prefix, int depth) {
    const auto document = files_.tree(file);
    if (!document || depth > deepest_part) return;
    const auto text = files_.texts().text(file);
    const TextPlaces places(*text);
    for (const char* section : {"inputs", "outputs"})
      if (const yaml::Node* ports = document->root.find(section); ports && depth == 0)
        for (const yaml::Entry& port : ports->entries) add(port.key, file, range_of(places, port));
    const yaml::Node* blocks = document->root.find("blocks");
    for (std::size_t i = 0; blocks && i < blocks->entries.size() && found_.size() < most_shapes; ++i)
      add_block(file, places, blocks->entries[i], prefix, depth);
  }

  std::map<std::string, FilePlace> take() { return std::move(found_); }

 private:
  static TextRange range_of(const TextPlaces& places, const yaml::Entry& entry) {
    const TextRange key = places.key_range(entry);
    return {key.from, std::max(key.to, places.offset(entry.value.end))};
  }

  void add(const std::string& name, const std::string& file, const TextRange& range) {
    found_.try_emplace(name, FilePlace{file, range});
  }

  void add_block(const std::string& file, const TextPlaces& places, const yaml::Entry& block,
                 const std::string& prefix, int depth) {
    const std::string name = prefix + block.key;
    add(name, file, range_of(places, block));
    for (const std::string& output : files_.outputs(file, block))
      add(name + "." + output, file, places.key_range(block));
    for (const yaml::Entry& key : block.value.entries) {
      add(name + "." + key.key, file, range_of(places, key));
      for (std::size_t i = 0; i < key.value.items.size(); ++i)
        add(name + "." + key.key + "." + std::to_string(i + 1), file, places.range(key.value.items[i]));
    }
    if (const std::string part = DiagramFiles::part_file(file, block); !part.empty())
      add_file(part, name + ".", depth + 1);
  }

  DiagramFiles& files_;
  std::map<std::string, FilePlace> found_;
};

/// Returns the text range of each item in the drawing of a file. Items are blocks with their keys, inputs
/// with their sources, and outputs, at the name of their block.
/// Names are those of the drawn graph: "cart", "cart.force", "sum.u.2" for lists, "rig.mount.x" within parts
/// (in their own files), "x" for ports of the file.
/// While the text is invalid YAML, the last valid one counts.
std::map<std::string, FilePlace> shape_places(DiagramFiles& files, const std::string& file) {
  Shapes shapes(files);
  shapes.add_file(file, "", 0);
  return shapes.take();
}

/// Conversion of ranges in several files to UTF-16.
class Utf16Files {
 public:
  explicit Utf16Files(DiagramFiles& files) : files_(files) {}

  Utf16Range range(const std::string& file, const TextRange& bytes) {
    const auto [known, is_new] = known_.try_emplace(file);
    if (is_new) {
      known->second.text = files_.texts().text(file);
      known->second.places.emplace(*known->second.text);
    }
    return {file, known->second.places->units(bytes.from), known->second.places->units(bytes.to)};
  }

 private:
  struct Known {
    std::shared_ptr<const std::string> text{};
    std::optional<Utf16Places> places{};
  };
  DiagramFiles& files_;
  std::map<std::string, Known> known_;
};

}  // namespace

void LanguageService::open(const std::string& file, std::string text) {
  files_.texts().open(file, std::move(text));
  known_.try_emplace(file);
  note_change(file);
}

void LanguageService::edit(const std::string& file, const EditorRange& range, const std::string& text) {
  const auto before = files_.texts().text(file);
  const TextPlaces places(*before);
  const std::size_t from = places.offset(range.start), to = std::max(from, places.offset(range.end));
  open(file, spliced(*before, {{{from, to}, text}}));
}

void LanguageService::close(const std::string& file) {
  files_.texts().close(file);
  known_.erase(file);
  note_change(file);
}

void LanguageService::note_saved() {
  for (auto& [file, known] : known_) known.draft_is_old = known.faults_are_old = true;
}

void LanguageService::note_change(const std::string& file) {
  changed_.insert(file);
  for (auto& [other, known] : known_)
    if (other == file || std::ranges::count(known.analysis.uses, file) > 0)
      known.draft_is_old = known.faults_are_old = true;
}

void LanguageService::take(Known& known, Analysis now) {
  known.draft_is_old = false;
  if (now.draft)
    known.analysis = std::move(now);
  else
    known.analysis.uses = std::move(now.uses);
}

const Analysis& LanguageService::with_draft(const std::string& file) {
  Known& known = known_[file];
  if (known.draft_is_old) take(known, analyse(files_, file, Depth::draft));
  return known.analysis;
}

bool LanguageService::analyse_next() {
  const auto next = std::ranges::find_if(known_, [](const auto& one) { return one.second.faults_are_old; });
  if (next == known_.end()) return false;
  Analysis now = analyse(files_, next->first);
  next->second.faults = now.faults;
  next->second.faults_are_old = false;
  take(next->second, std::move(now));
  return true;
}

std::vector<TextDiagnostic> LanguageService::diagnostics_of(const std::string& file) {
  std::vector<TextDiagnostic> all;
  for (const auto& [user, known] : known_)
    for (const yaml::Fault& fault : known.faults)
      if (auto one = diagnostic_of(fault, file, files_.texts())) add_diagnostic(std::move(*one), all);
  return all;
}

std::map<std::string, std::vector<TextDiagnostic>> LanguageService::take_diagnostics() {
  // Faults of an older text have no valid place in the newer one.
  if (std::ranges::any_of(known_, [](const auto& one) { return one.second.faults_are_old; })) return {};
  std::set<std::string> files;
  for (const auto& [file, before] : shown_) files.insert(file);
  for (const auto& [file, known] : known_) {
    files.insert(file);
    for (const yaml::Fault& fault : known.faults)
      if (!fault.place.file.empty()) files.insert(fault.place.file);
  }
  std::map<std::string, std::vector<TextDiagnostic>> changed;
  for (const std::string& file : files) {
    std::vector<TextDiagnostic> now = diagnostics_of(file);
    const auto before = shown_.find(file);
    if (before != shown_.end() && before->second == now && !changed_.contains(file)) continue;
    shown_[file] = changed[file] = std::move(now);
  }
  std::erase_if(shown_, [&](const auto& one) { return one.second.empty() && !known_.contains(one.first); });
  changed_.clear();
  return changed;
}

std::size_t LanguageService::offset(const std::string& file, const EditorPosition& at) {
  return TextPlaces(*files_.texts().text(file)).offset(at);
}

EditorPlace LanguageService::shown(const FilePlace& place) {
  return {place.file, TextPlaces(*files_.texts().text(place.file)).range(place.range)};
}

std::vector<std::pair<Completion, EditorRange>> LanguageService::completions(const std::string& file,
                                                                             const EditorPosition& at) {
  std::vector<std::pair<Completion, EditorRange>> shown;
  const auto text = files_.texts().text(file);
  TextPlaces places(*text);
  for (Completion& one : complete(files_, with_draft(file), file, places.offset(at))) {
    const EditorRange range = places.range(one.range);
    shown.emplace_back(std::move(one), range);
  }
  return shown;
}

std::optional<std::pair<std::string, EditorRange>> LanguageService::hover(const std::string& file,
                                                                          const EditorPosition& at) {
  const auto found = stepwire::language::hover(files_, with_draft(file), file, offset(file, at));
  if (!found) return std::nullopt;
  return std::pair(found->markdown, shown({file, found->range}).range);
}

std::optional<EditorPlace> LanguageService::definition(const std::string& file, const EditorPosition& at) {
  const std::size_t place = offset(file, at);
  if (const WrittenName* name = files_.name_at(file, place);
      name && name->sense == WrittenName::Sense::file) {
    const auto tree = files_.tree(file);
    const yaml::Entry* block = tree ? DiagramFiles::entry(*tree, "blocks", name->block) : nullptr;
    const std::string part = block ? DiagramFiles::part_file(file, *block) : "";
    if (!part.empty()) return EditorPlace{part, {}};
  }
  const auto piece = files_.piece_at(file, place);
  const auto found = piece ? files_.definition(piece->meaning) : std::nullopt;
  return found ? std::optional(shown(*found)) : std::nullopt;
}

std::vector<EditorPlace> LanguageService::references(const std::string& file, const EditorPosition& at,
                                                     bool with_definition) {
  const auto piece = files_.piece_at(file, offset(file, at));
  if (!piece) return {};
  const auto definition = files_.definition(piece->meaning);
  std::vector<EditorPlace> places;
  for (const FilePlace& place : files_.references(piece->meaning))
    if (with_definition || place != definition) places.push_back(shown(place));
  return places;
}

EditorRange LanguageService::renamed(const std::string& file, const EditorPosition& at) {
  return shown({file, renamed_piece(files_, file, offset(file, at)).range}).range;
}

FileEdits LanguageService::rename(const std::string& file, const EditorPosition& at,
                                  const std::string& name) {
  FileEdits edits;
  for (const auto& [path, splices] : stepwire::language::rename(files_, file, offset(file, at), name))
    for (const Splice& splice : splices)
      edits[path].emplace_back(shown({path, splice.range}).range, splice.text);
  return edits;
}

std::vector<OutlineItem> LanguageService::outline(const std::string& file) {
  try {
    return outline_of(*files_.texts().document(file), *files_.texts().text(file));
  } catch (const yaml::Error&) {
    return {};
  }
}

std::vector<Mending> LanguageService::mendings(const std::string& file, const EditorRange& range) {
  while (analyse_next()) {
  }
  std::vector<Mending> found;
  const auto text = files_.texts().text(file);
  for (TextDiagnostic& one : diagnostics_of(file)) {
    if (!one.mending || one.range.end < range.start || range.end < one.range.start) continue;
    try {
      static_cast<void>(spliced_values(*text, {*one.mending}));
    } catch (const EditRefused&) {
      continue;
    }
    const EditorRange where = shown({file, one.mending->range}).range;
    found.push_back({"change to '" + one.meant + "'", one, where, one.mending->text});
  }
  return found;
}

EditChanges LanguageService::edited(const std::string& file, Edit edit) {
  if (auto* set = std::get_if<SetValueAt>(&edit))
    set->offset = Utf16Places(*files_.texts().text(file)).offset(set->offset);
  Edited made = language::edited(files_, file, edit);
  EditChanges result{{}, std::move(made.name), std::move(made.faults)};
  Utf16Files places(files_);
  for (const auto& [path, splices] : made.changes)
    for (const Splice& splice : splices)
      result.changes.push_back({places.range(path, splice.range), splice.text});
  return result;
}

std::vector<InputName> LanguageService::inputs_for(const std::string& file, const std::string& from) {
  return language::inputs_for(files_, with_draft(file), file, from);
}

std::map<std::string, Utf16Range> LanguageService::shapes(const std::string& file) {
  std::map<std::string, Utf16Range> all;
  Utf16Files places(files_);
  for (const auto& [name, place] : shape_places(files_, file))
    all.emplace(name, places.range(place.file, place.range));
  return all;
}

}  // namespace stepwire::language
