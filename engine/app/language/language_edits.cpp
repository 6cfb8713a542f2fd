#include "engine/app/language/language_service.hpp"
#include "engine/app/language/shape_places.hpp"

namespace stepwire::language {

namespace {

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
