#include "engine/app/language/written_names.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "engine/base/unit/unit.hpp"

namespace stepwire::language {

namespace {

using Form = yaml::Key::Form;
using Sense = WrittenName::Sense;

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
std::size_t name_end(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_name_character(text[at]) ||
                              (text[at] == '.' && at + 1 < text.size() && is_name_character(text[at + 1]))))
    ++at;
  return at;
}

/// Returns the end of a number and its unit.
std::size_t number_end(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_digit(text[at]) || text[at] == '.')) ++at;
  const bool exponent = at + 1 < text.size() && (text[at] == 'e' || text[at] == 'E') &&
                        (is_digit(text[at + 1]) || (at + 2 < text.size() && is_digit(text[at + 2]) &&
                                                    !is_name_character(text[at + 1])));
  if (exponent)
    for (at += 2; at < text.size() && is_digit(text[at]);) ++at;
  std::size_t unit = at;
  while (unit < text.size() && text[unit] == ' ') ++unit;
  const std::size_t length = unit::unit_prefix(text.substr(unit), [](std::string_view) { return false; });
  return length > 0 ? unit + length : at;
}

/// Returns the end of the token at `at`, which is no name.
std::size_t past(std::string_view text, std::size_t at) {
  if (is_digit(text[at])) return number_end(text, at);
  return at + (text[at] == '\\' ? 2 : 1);
}

/// Collector of the names of a file, which traverses its tree.
class Gathering {
 public:
  Gathering(std::string_view text, Forms& forms) : places_(text), forms_(forms) {}

  std::vector<WrittenName> all(const yaml::Node& root) {
    gather(root, forms_.root());
    std::ranges::stable_sort(found_, {}, &WrittenName::range);
    const auto same = [](const WrittenName& a, const WrittenName& b) {
      return a.range == b.range && a.sense == b.sense;
    };
    found_.erase(std::unique(found_.begin(), found_.end(), same),
                 found_.end());  // aliases repeat the ranges of their anchors
    return std::move(found_);
  }

 private:
  void gather(const yaml::Node& node, const FormList& forms) {
    if (node.is_scalar()) return scalar(node, forms);
    for (const yaml::Node& item : node.items) gather(item, forms_.items(forms));
    if (!node.is_map()) return;
    const bool is_block =
        std::ranges::any_of(forms, [](const yaml::Key* form) { return is_block_form(*form); });
    for (const yaml::Entry& entry : node.entries) {
      if (is_block) key_of_block(node, entry);
      const FormList below = forms_.under(forms, node, entry.key);
      if (!is_block) key(node, entry, forms, below);
      const std::string outer = block_;
      if (std::ranges::any_of(below, [](const yaml::Key* form) { return is_block_form(*form); }))
        block_ = entry.key;
      gather(entry.value, below);
      block_ = outer;
    }
  }

  void add(const TextRange& range, std::string name, Sense sense) {
    found_.push_back({range, std::move(name), sense, block_});
  }

  /// Adds a key that defines or uses a name.
  void key(const yaml::Node& map, const yaml::Entry& entry, const FormList& forms, const FormList& below) {
    for (const yaml::Key* form : below) {
      if (is_block_form(*form)) return add(unquoted(places_.key_range(entry)), entry.key, Sense::block);
      if (form->form != Form::section) continue;
      if (form->refers == "parameter")
        return add(unquoted(places_.key_range(entry)), entry.key, Sense::defined);
      if (form->refers == "input") return add(unquoted(places_.key_range(entry)), entry.key, Sense::input);
      if (form->refers == "output") return add(unquoted(places_.key_range(entry)), entry.key, Sense::output);
    }
    for (const yaml::Key* form : forms_.maps(forms, map)) {
      const yaml::Key* named = form->form == Form::names                     ? form
                               : form->rest.empty() || form->find(entry.key) ? nullptr
                                                                             : &form->rest.front();
      if (named && form->form == Form::names && form->names == yaml::Key::Names::nothing) continue;
      if (named) name(places_.key_range(entry), entry.key, named->names);
    }
  }

  void key_of_block(const yaml::Node& map, const yaml::Entry& entry) {
    if (entry.key == "block") return add(places_.range(entry.value), entry.value.text, Sense::type);
    if (entry.key == "diagram") return add(places_.range(entry.value), entry.value.text, Sense::file);
    add(places_.key_range(entry), entry.key, map.find("block") ? Sense::block_key : Sense::part_key);
  }

  /// Adds a scalar that is a name as a whole.
  void name(const TextRange& range, const std::string& text, yaml::Key::Names what) {
    if (what == yaml::Key::Names::block) add(unquoted(range), text, Sense::inside);
    if (what == yaml::Key::Names::parameter) add(unquoted(range), text, Sense::parameter);
    if (what == yaml::Key::Names::signal) add(unquoted(range), text, Sense::signal);
  }

  TextRange unquoted(TextRange range) const {
    const std::string_view raw = range.in(places_.text());
    const bool quoted = raw.size() > 1 && (raw.front() == '"' || raw.front() == '\'');
    return quoted ? TextRange{range.from + 1, range.to - 1} : range;
  }

  void scalar(const yaml::Node& node, const FormList& forms) {
    const TextRange range = unquoted(places_.range(node));
    const std::string_view raw = range.in(places_.text());
    const bool computed = raw.starts_with('=');
    bool signals = false, parameters = computed, in_unit = false;
    for (const yaml::Key* form : forms_.scalars(forms)) {
      const bool expression = form->form == Form::expression || form->form == Form::series;
      const bool source =
          form->form == Form::source && !computed && !raw.starts_with('$') && !unit::parse_quantity(raw);
      signals = signals || expression || source ||
                (form->form != Form::source && form->names == yaml::Key::Names::signal);
      in_unit = in_unit || expression || form->names == yaml::Key::Names::signal;
      parameters = parameters || (form->form != Form::text && form->form != Form::string) || !block_.empty();
      if (form->names == yaml::Key::Names::parameter) return add(range, node.text, Sense::parameter);
      if (form->names == yaml::Key::Names::block) return add(range, node.text, Sense::inside);
    }
    const std::size_t unit = in_unit ? raw.rfind(" in ") : std::string_view::npos;
    for (const NameInText& found : names_in_expression(raw.substr(0, std::min(unit, raw.size())))) {
      const TextRange at{range.from + found.range.from, range.from + found.range.to};
      const bool parameter = found.parameter || computed;
      if (parameter ? parameters : signals)
        add(at, std::string(at.in(places_.text())), parameter ? Sense::parameter : Sense::signal);
    }
  }

  TextPlaces places_;
  Forms& forms_;
  std::vector<WrittenName> found_;
  std::string block_;
};

}  // namespace

bool is_name_character(char c) {
  return is_letter(c) || is_digit(c);
}

std::vector<NameInText> names_in_expression(std::string_view text) {
  std::vector<NameInText> found;
  for (std::size_t at = 0; at < text.size();) {
    const bool parameter = text[at] == '$' && at + 1 < text.size() && is_letter(text[at + 1]);
    const std::size_t begin = at + (parameter ? 1 : 0);
    if (!is_letter(text[begin])) {
      at = past(text, at);
      continue;
    }
    at = begin;
    // A parameter after '$' is one of the file itself, so its name has no dots.
    while (parameter && at < text.size() && is_name_character(text[at])) ++at;
    if (!parameter) at = name_end(text, begin);
    found.push_back({{begin, at}, parameter});
  }
  return found;
}

std::vector<WrittenName> written_names(const yaml::Document& document, std::string_view text, Forms& forms) {
  return Gathering(text, forms).all(document.root);
}

}  // namespace stepwire::language
