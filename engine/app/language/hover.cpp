#include "engine/app/language/hover.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/app/language/signal_list.hpp"
#include "engine/app/language/tree_place.hpp"
#include "engine/app/reference/block_page.hpp"
#include "engine/app/reference/key_words.hpp"
#include "engine/app/reference/sheet_text.hpp"
#include "engine/app/reference/words.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::language {
namespace {

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
    const std::string path = DiagramFiles::part_file(user, entry);
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

}  // namespace

std::optional<Hover> hover(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                           std::size_t offset) {
  return Hovering(files, analysis, file, offset).find();
}

}  // namespace stepwire::language
