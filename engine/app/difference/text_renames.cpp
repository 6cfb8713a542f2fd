#include "engine/app/difference/text_renames.hpp"

#include "engine/app/language/diagram_files.hpp"

namespace stepwire::difference {
namespace {

using language::Meaning;

std::optional<NameKind> kind_of(Meaning::Kind kind) {
  if (kind == Meaning::Kind::block) return NameKind::block;
  if (kind == Meaning::Kind::parameter) return NameKind::parameter;
  if (kind == Meaning::Kind::input) return NameKind::input;
  if (kind == Meaning::Kind::output) return NameKind::output;
  return std::nullopt;
}

std::vector<language::Splice> splices_of(language::DiagramFiles& files, const std::string& file,
                                         const NewNames& names) {
  std::vector<language::Splice> splices;
  const std::vector<language::WrittenName> all = files.names(file);  // copied: pieces() reads other files
  for (const language::WrittenName& name : all)
    for (const language::NamePiece& piece : files.pieces(file, name)) {
      const auto kind = piece.meaning.file == file ? kind_of(piece.meaning.kind) : std::nullopt;
      const auto found = kind ? names.find({*kind, piece.meaning.name}) : names.end();
      if (found != names.end()) splices.push_back({piece.range, found->second});
    }
  return splices;
}

void remove_marks(Fact& fact) {
  fact.key = unmarked(fact.key);
  for (Fact& part : fact.parts) remove_marks(part);
  if (fact.kind == Fact::Kind::value)
    fact.canonical = unmarked(fact.canonical);
  else
    join_parts(fact);
}

}  // namespace

std::string meaning_of(const Fact& root) {
  Fact plain = root;
  remove_marks(plain);
  return plain.canonical;
}

std::optional<std::string> with_new_names(const Registry& registry, Texts& texts, const std::string& file,
                                          const NewNames& names) {
  const DiagramText& source = texts.read(file);
  if (names.empty()) return source.text;
  FactReader reader(registry, texts);
  Fact wanted = reader.read(file).root;
  rename(wanted, names);
  language::DiagramFiles files(registry);
  files.texts().open(file, source.text);
  try {
    std::string text = language::spliced(source.text, splices_of(files, file, names));
    Texts after = texts.with(file, text);
    FactReader again(registry, after);
    if (meaning_of(again.read(file).root) == meaning_of(wanted)) return text;
  } catch (const language::EditRefused&) {
  } catch (const yaml::Error&) {
  }
  return std::nullopt;
}

}  // namespace stepwire::difference
