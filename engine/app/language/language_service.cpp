#include "engine/app/language/language_service.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>

#include "engine/app/language/diagram_files.hpp"
#include "engine/app/language/signal_list.hpp"
#include "engine/app/language/tree_place.hpp"
#include "engine/app/reference/block_page.hpp"
#include "engine/app/reference/key_words.hpp"
#include "engine/app/reference/sheet_text.hpp"
#include "engine/app/reference/words.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/fault_place.hpp"

namespace stepwire::language {

namespace {

/// Returns the end of the text in a line, before a comment.
std::size_t end_of_line(std::string_view text, std::size_t from) {
  const std::size_t line = std::min(text.find('\n', from), text.size());
  const std::size_t comment = std::min(text.substr(0, line).find(" #", from), line);
  std::size_t end = comment;
  while (end > from && std::isspace(static_cast<unsigned char>(text[end - 1]))) --end;
  return end > from ? end : std::min(from + 1, text.size());
}

/// Returns the range of a fault in its file, which need not be valid YAML.
TextRange range_of(const yaml::Fault& fault, OpenTexts& texts, const TextPlaces& places) {
  const yaml::Mark& mark = fault.place.mark;
  if (mark.line < 1) return {0, end_of_line(places.text(), 0)};
  const std::size_t from = places.offset(mark);
  try {
    if (const auto end = yaml::end_of_fault(texts.document(fault.place.file)->root, fault))
      if (places.offset(*end) > from) return {from, places.offset(*end)};
  } catch (const yaml::Error&) {  // the fault of the YAML is reported at its own place
  }
  return {from, end_of_line(places.text(), from)};
}

std::optional<Splice> mending_of(const yaml::Fault& fault, std::string_view text, const TextRange& range) {
  const auto& suggestion = fault.message.suggestion;
  if (!suggestion || suggestion->written.empty()) return std::nullopt;
  const auto at = yaml::find_word(text, range.from, range.to, suggestion->written);
  if (!at) return std::nullopt;
  return Splice{{*at, *at + suggestion->written.size()}, suggestion->meant};
}

std::string words_of(const yaml::Fault& fault) {
  const std::string words = fault.message.text();
  return text::visible(fault.subject.empty() ? words : fault.subject + ": " + words);
}

TextDiagnostic::Related related(const yaml::Place& place, std::string message, OpenTexts& texts) {
  const auto text = texts.text(place.file);
  TextPlaces places(*text);
  const TextRange range = range_of(yaml::Fault{place, "", "", {}}, texts, places);
  return {place.file, places.range(range), std::move(message)};
}

/// Converts a fault within the file itself.
TextDiagnostic own(const yaml::Fault& fault, OpenTexts& texts) {
  const auto text = texts.text(fault.place.file);
  TextPlaces places(*text);
  const TextRange range = range_of(fault, texts, places);
  TextDiagnostic found{places.range(range), words_of(fault), {}, mending_of(fault, *text, range)};
  found.text = fault.message.text();
  if (found.mending) found.meant = fault.message.suggestion->meant;
  for (const yaml::Place& user : fault.used_by) found.related.push_back(related(user, "used here", texts));
  return found;
}

/// Converts a fault within a part to a diagnostic at the place that uses the part.
TextDiagnostic in_part(const yaml::Fault& fault, const yaml::Place& user, OpenTexts& texts) {
  const std::string part = std::filesystem::path(fault.place.file).filename().string();
  TextDiagnostic::Related there = related(fault.place, words_of(fault), texts);
  TextDiagnostic found{
      related(user, "", texts).range, fmt::format("in {}: {}", part, words_of(fault)), {}, {}};
  found.text = found.message;
  found.related.push_back(std::move(there));
  return found;
}

using ItemKind = OutlineItem::Kind;

/// Returns the sections whose entries are listed, with the kind of their items.
const std::map<std::string, ItemKind>& listed_sections() {
  static const std::map<std::string, ItemKind> all{
      {"blocks", ItemKind::block}, {"parameters", ItemKind::parameter}, {"inputs", ItemKind::port},
      {"outputs", ItemKind::port}, {"claims", ItemKind::claim},         {"invariants", ItemKind::claim}};
  return all;
}

std::string scalar_under(const yaml::Node& map, const char* key) {
  const yaml::Node* value = map.is_map() ? map.find(key) : nullptr;
  return value && value->is_scalar() ? value->text : "";
}

std::string detail_of(const yaml::Node& value, ItemKind kind) {
  if (value.is_scalar()) return value.text;
  if (kind != ItemKind::block) return scalar_under(value, kind == ItemKind::port ? "unit" : "value");
  const std::string type = scalar_under(value, "block");
  return type.empty() ? scalar_under(value, "diagram") : type;
}

class Outlining {
 public:
  explicit Outlining(std::string_view text) : places_(text) {}

  std::vector<OutlineItem> sections(const yaml::Node& root) {
    std::vector<OutlineItem> items;
    for (const yaml::Entry& entry : root.entries) {
      items.push_back(item(entry, ItemKind::section));
      const auto listed = listed_sections().find(entry.key);
      if (listed == listed_sections().end()) continue;
      for (const yaml::Entry& inner : entry.value.entries)
        items.back().children.push_back(item(inner, listed->second));
      for (const yaml::Node& claim : entry.value.items) items.back().children.push_back(statement(claim));
    }
    return items;
  }

 private:
  OutlineItem item(const yaml::Entry& entry, ItemKind kind) {
    const bool part = kind == ItemKind::block && !scalar_under(entry.value, "diagram").empty();
    const TextRange key = places_.key_range(entry);
    const TextRange whole{key.from, std::max(key.to, places_.range(entry.value).to)};
    const std::string name = entry.key.empty() ? "''" : entry.key;  // editors refuse an empty name
    return {name,
            detail_of(entry.value, kind),
            part ? ItemKind::part : kind,
            places_.range(whole),
            places_.range(key),
            {}};
  }

  OutlineItem statement(const yaml::Node& claim) {
    const std::string that = scalar_under(claim, "that");
    const EditorRange range = places_.range(places_.range(claim));
    return {that.empty() ? "claim" : that, "", ItemKind::claim, range, range, {}};
  }

  TextPlaces places_;
};

using Sense = WrittenName::Sense;

/// Formats a word of the file as Markdown code.
std::string code(const std::string& word) {
  std::string shown = text::visible(word);
  std::erase(shown, '`');
  return "`" + shown + "`";
}

std::string unit_words(const std::optional<unit::Dimension>& dimension) {
  if (!dimension) return "unit not known";
  return *dimension == unit::Dimension{} ? "no unit" : "in " + unit::si_name(*dimension);
}

/// Formats a named fact; empty for an empty text.
std::string fact(const char* name, const std::string& text) {
  return text.empty() ? "" : fmt::format("\n- {}: {}", name, reference::escaped(text));
}

std::string key_markdown(const std::string& name, const yaml::Key& key) {
  const bool section = key.form == yaml::Key::Form::section, any = key.form == yaml::Key::Form::value;
  std::string text = fmt::format("{}: {}", code(name), reference::escaped(key.doc));
  if (!any)
    text += fact("value", section ? "see `stepwire format " + key.refers + "`" : reference::form_text(key));
  text += fact("unit", key.unit);
  text +=
      fact("range", reference::range_text(key).empty() && !section ? key.refers : reference::range_text(key));
  text += fact("default", key.required ? "required" : key.otherwise);
  return text + fact("example", key.example);
}

class Hovering {
 public:
  Hovering(DiagramFiles& files, const Analysis& analysis, const std::string& file, std::size_t offset)
      : files_(files), analysis_(analysis), file_(file), offset_(offset) {}

  std::optional<Hover> find() {
    const WrittenName* name = files_.name_at(file_, offset_);
    if (name && name->sense == Sense::type)
      if (const BlockType* type = files_.registry().find(name->name))
        return Hover{reference::block_markdown(*type), name->range};
    const bool is_key = name && (name->sense == Sense::block_key || name->sense == Sense::part_key);
    if (name && !is_key)
      if (auto found = of_name(*name)) return found;
    return of_place();
  }

 private:
  std::optional<Hover> of_name(const WrittenName& name) {
    for (const NamePiece& piece : files_.pieces(file_, name)) {
      if (!piece.range.contains(offset_)) continue;
      const std::string whole = name.name.substr(0, piece.range.to - name.range.from);
      const std::string text = of_meaning(piece.meaning, whole);
      if (!text.empty()) return Hover{text, piece.range};
    }
    return std::nullopt;
  }

  /// Describes a definition; `whole` is its name in this file.
  std::string of_meaning(const Meaning& meaning, const std::string& whole) {
    if (meaning.kind == Meaning::Kind::parameter) return of_parameter(whole);
    if (meaning.kind == Meaning::Kind::block) return of_block(meaning, whole);
    return of_signal(whole);
  }

  std::string of_parameter(const std::string& whole) const {
    const diagram::DiagramParameter* parameter = parameter_of(analysis_, whole);
    if (!parameter) return "";
    const double* number = std::get_if<double>(&parameter->value.content);
    std::string text = fmt::format("{} = {}", code(whole), code(parameter->text));
    if (number)
      text +=
          fmt::format(" ({} {})", *number, parameter->dimension ? unit::si_name(*parameter->dimension) : "");
    return text + (parameter->doc.empty() ? "" : "\n\n" + reference::escaped(parameter->doc));
  }

  std::string of_block(const Meaning& meaning, const std::string& whole) {
    const auto tree = files_.tree(meaning.file);
    const yaml::Entry* entry = tree ? DiagramFiles::entry(*tree, "blocks", meaning.name) : nullptr;
    if (!entry) return "";
    const yaml::Node* kind = entry->value.is_map() ? entry->value.find("block") : nullptr;
    const BlockType* type = kind ? files_.registry().find(kind->text) : nullptr;
    std::string text = type ? fmt::format("{}: {}. {}", code(whole), type->name,
                                          reference::escaped(reference::first_sentence(type->doc)))
                            : fmt::format("{}: {}", code(whole), of_part(meaning.file, *entry));
    for (const KnownSignal& signal : signals_of(analysis_, files_, file_, true))
      if (signal.name == whole || signal.name.starts_with(whole + "."))
        text += fmt::format("\n- {}: {}", code(signal.name), unit_words(signal.dimension));
    return text;
  }

  std::string of_part(const std::string& user, const yaml::Entry& entry) {
    const std::string path = files_.part_file(user, entry);
    const auto part = path.empty() ? nullptr : files_.tree(path);
    const yaml::Node* title = part ? part->root.find("title") : nullptr;
    return "part" + (title ? ", " + reference::escaped(title->text) : "");
  }

  std::string of_signal(const std::string& whole) {
    for (const KnownSignal& signal : signals_of(analysis_, files_, file_, true))
      if (signal.name == whole)
        return fmt::format("{}: {}, {}", code(whole), reference::escaped(signal.what),
                           unit_words(signal.dimension));
    return "";
  }

  std::optional<Hover> of_place() {
    const auto place = tree_place(files_, file_, offset_);
    if (!place || !place->entry) return std::nullopt;
    for (const yaml::Key* form : place->forms) {
      if (place->on_key && !form->doc.empty())
        return Hover{key_markdown(place->entry->key, *form), place->range};
      if (place->on_key) continue;
      const auto word = std::ranges::find(form->words, place->scalar->text, &yaml::Key::Word::word);
      if (word != form->words.end() && !word->doc.empty())
        return Hover{fmt::format("{}: {}", code(word->word), reference::escaped(word->doc)), place->range};
    }
    return std::nullopt;
  }

  DiagramFiles& files_;
  const Analysis& analysis_;
  const std::string& file_;
  std::size_t offset_;
};

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
    if (const std::string part = files_.part_file(file, block); !part.empty())
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

/// Converts a fault to a diagnostic of the file: the fault itself, or the fault of a part at the place that
/// uses it. Returns std::nullopt for faults of other files.
std::optional<TextDiagnostic> diagnostic_of(const yaml::Fault& fault, const std::string& file,
                                            OpenTexts& texts) {
  if (fault.place.file == file) return own(fault, texts);
  for (const yaml::Place& user : fault.used_by)
    if (user.file == file) return in_part(fault, user, texts);
  return std::nullopt;
}

/// Adds a diagnostic. A fault that was found both in a part alone and in its users is merged into one.
void add_diagnostic(TextDiagnostic diagnostic, std::vector<TextDiagnostic>& all) {
  const auto known = std::ranges::find_if(all, [&](const TextDiagnostic& one) {
    return one.range.start == diagnostic.range.start && one.range.end == diagnostic.range.end &&
           one.text == diagnostic.text;
  });
  if (known == all.end()) return all.push_back(std::move(diagnostic));
  if (diagnostic.message.size() < known->message.size())
    known->message = diagnostic.message;  // the message with the part's own names
  std::ranges::move(diagnostic.related, std::back_inserter(known->related));
}

std::vector<OutlineItem> outline_of(const yaml::Document& document, std::string_view text) {
  return Outlining(text).sections(document.root);
}

/// Returns the reference of a block or key, the unit of a signal, or unit and value of a parameter;
/// std::nullopt for other places.
std::optional<Hover> hover(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                           std::size_t offset) {
  return Hovering(files, analysis, file, offset).find();
}

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
    const std::string part = block ? files_.part_file(file, *block) : "";
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
