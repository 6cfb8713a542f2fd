#include "engine/base/yaml/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <tuple>
#include <utility>

#include "engine/base/text/characters.hpp"
#include "engine/base/text/nearest.hpp"

namespace stepwire::yaml {
namespace {

constexpr std::size_t max_faults = 100;
constexpr std::size_t longest_line = 4000;  // [bytes]

std::string text_of(const Place& place) {
  if (place.mark.line == 0) return place.file;
  const std::string in_file = fmt::format("{}:{}", place.mark.line, place.mark.column);
  return place.file.empty() ? in_file : place.file + ":" + in_file;
}

bool same(const Place& a, const Place& b) {
  return a.file == b.file && a.mark.line == b.mark.line && a.mark.column == b.mark.column;
}

bool same_fault(const Fault& a, const Fault& b) {
  return same(a.place, b.place) && a.subject == b.subject && a.message == b.message &&
         std::equal(a.used_by.begin(), a.used_by.end(), b.used_by.begin(), b.used_by.end(), same);
}

using PlaceKey = std::tuple<std::ptrdiff_t, int, int>;
using KeyedFault = std::pair<PlaceKey, Fault>;

// Sorts faults by location; files keep the order in which they first occur, which is that of reading.
std::vector<KeyedFault> by_place(std::vector<Fault> faults) {
  std::vector<std::string> files;
  const auto rank = [&](const std::string& file) {
    const auto at = std::find(files.begin(), files.end(), file);
    if (at != files.end()) return at - files.begin();
    files.push_back(file);
    return static_cast<std::ptrdiff_t>(files.size()) - 1;
  };
  std::vector<KeyedFault> keyed;
  keyed.reserve(faults.size());
  for (Fault& fault : faults) {
    const PlaceKey key{rank(fault.place.file), fault.place.mark.line, fault.place.mark.column};
    keyed.emplace_back(key, std::move(fault));
  }
  std::stable_sort(keyed.begin(), keyed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  return keyed;
}

std::vector<Fault> without_duplicates(std::vector<KeyedFault> keyed) {
  std::vector<Fault> sorted;
  sorted.reserve(keyed.size());
  std::size_t first_here = 0;  // duplicates occur only among the faults of one location
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    if (i > 0 && keyed[i].first != keyed[i - 1].first) first_here = sorted.size();
    const auto is_known = [&](const Fault& known) { return same_fault(known, keyed[i].second); };
    if (std::none_of(sorted.begin() + static_cast<std::ptrdiff_t>(first_here), sorted.end(), is_known))
      sorted.push_back(std::move(keyed[i].second));
  }
  return sorted;
}

}  // namespace

std::string Fault::text() const {
  std::string line = text_of(place);
  if (!line.empty()) line += ": ";
  if (!subject.empty()) line += subject + ": ";
  line += message.text();
  for (const Place& user : used_by) line += " (used by " + text_of(user) + ")";
  if (line.size() > longest_line) {
    std::size_t end = longest_line;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xc0) == 0x80)
      --end;  // not within a UTF-8 character
    line = fmt::format("{} ... and {} bytes more", line.substr(0, end), line.size() - end);
  }
  return text::visible(line);  // escapes line breaks of the user's text, since a fault is one line
}

Error::Error(Fault fault) : Error(std::vector<Fault>{std::move(fault)}) {}

Error::Error(std::vector<Fault> faults) : faults_(without_duplicates(by_place(std::move(faults)))) {
  for (const Fault& fault : faults_) text_ += (text_.empty() ? "" : "\n") + fault.text();
}

void Faults::add(Fault fault) {
  faults_.push_back(std::move(fault));
  if (faults_.size() < max_faults) return;
  faults_.push_back({.place = {},
                     .subject = "",
                     .message = fmt::format("there may be more than these {} faults", max_faults),
                     .used_by = {}});
  throw Error(faults_);
}

void Faults::throw_if_any() const {
  if (!faults_.empty()) throw Error(faults_);
}

Message did_you_mean(const std::string& word, const std::vector<std::string>& names) {
  const std::string* const nearest = text::nearest(word, names);
  if (!nearest) return {};
  return {"", "did you mean '" + *nearest + "'?", Suggestion{word, *nearest}};
}

Message did_you_mean(const std::string& word, const std::vector<std::string>& names,
                     const std::string& sentence) {
  Message message = did_you_mean(word, names);
  message += (message.empty() ? ". " : " ") + sentence;
  return message;
}

Message nearest_or_all(const std::string& word, const std::vector<std::string>& names, std::string what) {
  constexpr std::size_t most = 24;
  Message message = did_you_mean(word, names);
  if (!message.empty())
    what.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(what.front())));
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size()));
  const std::string all =
      fmt::format("{}: {}{}", what, fmt::join(names.begin(), end, ", "), names.size() > most ? ", ..." : "");
  message.cure += message.cure.empty() ? all : " " + all;
  return message;
}

Message unknown_key(const std::string& key, const std::vector<std::string>& known, const std::string& owner) {
  const std::string message = fmt::format("{} has no '{}'", owner, key);
  if (key.find_first_of("()+*/<>=&|?$") != std::string::npos)
    return {message,
            "it looks like a piece of an expression: put an expression with a comma or a colon in quotes"};
  if (key.find(' ') != std::string::npos)
    return {message, "it looks like a piece of a sentence: put a text with a comma or a colon in quotes"};
  return message + nearest_or_all(key, known, "it has");
}

}  // namespace stepwire::yaml
