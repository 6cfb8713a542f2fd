#include "tests/engine/app/language/editing.hpp"

#include <catch2/catch.hpp>

#include "blocks/register.hpp"

namespace stepwire::language {

namespace {

const Registry& all_blocks() {
  static const Registry registry = blocks();
  return registry;
}

}  // namespace

std::string in_range(const std::string& text, const EditorRange& range) {
  const TextPlaces places(text);
  const std::size_t from = places.offset(range.start);
  return text.substr(from, places.offset(range.end) - from);
}

Editing::Editing() : service_(all_blocks()) {
  service_.set_folders({folder_.path("")});
}

void Editing::open(const std::string& name, const std::string& text) {
  texts_[name] = text;
  service_.open(path(name), text);
}

void Editing::write(const std::string& name, const std::string& text) {
  texts_[name] = text;
  std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
  folder_.file(name, text);
}

std::vector<TextDiagnostic> Editing::diagnostics(const std::string& name) {
  while (service_.analyse_next()) {
  }
  for (auto& [file, list] : service_.take_diagnostics()) shown_[file] = list;
  return shown_[path(name)];
}

std::vector<std::string> Editing::wrong(const std::string& name) {
  std::vector<std::string> all;
  for (const TextDiagnostic& one : diagnostics(name))
    all.push_back(in_range(text(name), one.range) + ": " + one.message);
  return all;
}

EditorPosition Editing::at(const std::string& name, std::string_view word, std::size_t behind) const {
  const std::size_t place = text(name).find(word);
  REQUIRE(place != std::string::npos);
  return TextPlaces(text(name)).position(place + behind);
}

std::vector<std::string> Editing::labels(const std::string& name, std::string_view word, std::size_t behind) {
  std::vector<std::string> all;
  for (const auto& [one, range] : service_.completions(path(name), at(name, word, behind)))
    all.push_back(one.label);
  return all;
}

std::string Editing::hover(const std::string& name, std::string_view word, std::size_t behind) {
  const auto found = service_.hover(path(name), at(name, word, behind));
  return found ? found->first : "";
}

std::map<std::string, std::string> Editing::renamed(const std::string& name, std::string_view word,
                                                    std::size_t behind, const std::string& to) {
  std::map<std::string, std::string> after;
  for (const auto& [file, edits] : service_.rename(path(name), at(name, word, behind), to)) {
    const std::string short_name = file.substr(path("").size());
    const TextPlaces places(text(short_name));
    std::vector<Splice> splices;
    for (const auto& [range, put] : edits)
      splices.push_back({{places.offset(range.start), places.offset(range.end)}, put});
    after[short_name] = spliced(text(short_name), splices);
  }
  return after;
}

std::map<std::string, std::string> Editing::edited(const std::string& name, const Edit& edit) {
  std::map<std::string, std::vector<Splice>> splices;
  for (const auto& [range, put] : service_.edited(path(name), edit).changes) {
    const std::string short_name = range.file.substr(path("").size());
    const Utf16Places places(text(short_name));
    splices[short_name].push_back({{places.offset(range.from), places.offset(range.to)}, put});
  }
  std::map<std::string, std::string> after;
  for (const auto& [file, list] : splices) after[file] = spliced(text(file), list);
  return after;
}

}  // namespace stepwire::language
