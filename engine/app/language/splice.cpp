#include "engine/app/language/splice.hpp"

#include <algorithm>
#include <stdexcept>

namespace stepwire::language {

namespace {

/// Comparison of the trees before and after the splices.
class Comparison {
 public:
  Comparison(std::string_view text, const std::vector<Splice>& splices) : places_(text), splices_(splices) {}

  void compare(const yaml::Node& before, const yaml::Node& after) const {
    const bool same_form = before.kind == after.kind && before.quoted == after.quoted &&
                           before.items.size() == after.items.size() &&
                           before.entries.size() == after.entries.size();
    const bool same_text = before.text == after.text || touched(places_.range(before));
    if (!same_form || !same_text) refuse();
    for (std::size_t i = 0; i < before.items.size(); ++i) compare(before.items[i], after.items[i]);
    for (std::size_t i = 0; i < before.entries.size(); ++i) {
      const yaml::Entry& entry = before.entries[i];
      if (entry.key != after.entries[i].key && !touched(places_.key_range(entry))) refuse();
      compare(entry.value, after.entries[i].value);
    }
  }

 private:
  bool touched(const TextRange& range) const {
    return std::ranges::any_of(splices_, [&](const Splice& splice) {
      return range.contains(splice.range.from) && range.contains(splice.range.to);
    });
  }
  [[noreturn]] static void refuse() { throw EditRefused("this would change more of the file than the name"); }

  TextPlaces places_;
  const std::vector<Splice>& splices_;
};

}  // namespace

std::string spliced(std::string_view text, std::vector<Splice> splices) {
  std::ranges::stable_sort(splices, {}, &Splice::range);
  std::string result;
  std::size_t at = 0;
  for (const Splice& splice : splices) {
    if (splice.range.from < at || splice.range.to < splice.range.from || splice.range.to > text.size())
      throw EditRefused("two changes of one place");
    result += text.substr(at, splice.range.from - at);
    result += splice.text;
    at = splice.range.to;
  }
  return result += text.substr(at);
}

std::string spliced_values(std::string_view text, const std::vector<Splice>& splices) {
  std::string result = spliced(text, splices);
  try {
    const yaml::Document before = yaml::parse_document(text, ""), after = yaml::parse_document(result, "");
    Comparison(text, splices).compare(before.root, after.root);
  } catch (const yaml::Error& error) {
    throw EditRefused(std::string("the file could not be read any more: ") + error.what());
  }
  return result;
}

}  // namespace stepwire::language
