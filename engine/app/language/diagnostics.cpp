#include "engine/app/language/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>

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

}  // namespace

std::optional<TextDiagnostic> diagnostic_of(const yaml::Fault& fault, const std::string& file,
                                            OpenTexts& texts) {
  if (fault.place.file == file) return own(fault, texts);
  for (const yaml::Place& user : fault.used_by)
    if (user.file == file) return in_part(fault, user, texts);
  return std::nullopt;
}

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

}  // namespace stepwire::language
