#include "engine/app/language/writing_place.hpp"

#include <algorithm>
#include <cctype>

namespace stepwire::language {

namespace {

/// Improbable name, inserted at the cursor before parsing.
constexpr std::string_view probe = "zzcursorzz";

bool is_in_name(char c) {
  return is_name_character(c) || c == '.';
}

/// Returns the closing brackets for those that are open at the end of a text.
std::string closing_brackets(std::string_view text) {
  std::string open;
  char before = '\n', quote = 0;  // last nonblank character; quote character of the current string, or 0
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    const bool starts_value = std::string_view("\n:,[{-").find(before) != std::string_view::npos;
    if (quote) {
      if (c == '\\' && quote == '"') ++at;
      if (c == quote) quote = 0;
    } else if ((c == '"' || c == '\'') && starts_value) {
      quote = c;
    } else if (c == '#' && (at == 0 || std::isspace(static_cast<unsigned char>(text[at - 1])))) {
      at = std::min(text.find('\n', at), text.size()) - 1;
    } else if ((c == '[' || c == '{') && (starts_value || !open.empty())) {
      open += c == '[' ? ']' : '}';
    } else if (!open.empty() && c == open.back()) {
      open.pop_back();
    }
    if (c == '\n' || !std::isspace(static_cast<unsigned char>(c))) before = c;
  }
  return {open.rbegin(), open.rend()};
}

/// Returns trial texts with a name at the cursor, one of which may be valid YAML. They are unchanged, with
/// the name as a key, with brackets closed at the end of the line, and without the text that follows.
std::vector<std::string> probed_texts(std::string_view text, std::size_t offset) {
  const std::string start = std::string(text.substr(0, offset)) + std::string(probe);
  const std::size_t line = std::min(text.find('\n', offset), text.size());
  const std::string rest(text.substr(offset, line - offset)), below(text.substr(line));
  const std::string close = closing_brackets(text.substr(0, offset)),
                    close_line = closing_brackets(text.substr(0, line));
  return {start + rest + below,  start + ": " + rest + below,   start + rest + close_line + below,
          start + close + below, start + ": x" + close + below, start + "\"" + close + below,
          start + close + "\n",  start + ": x" + close + "\n"};
}

class Search {
 public:
  Search(Forms& forms, WritingPlace& cursor) : forms_(forms), cursor_(cursor) {}

  bool find(const yaml::Node& node, const FormList& forms) {
    if (node.is_scalar()) return in_scalar(node, forms);
    for (const yaml::Node& item : node.items)
      if (find(item, forms_.items(forms))) return true;
    for (const yaml::Entry& entry : node.entries)
      if (in_entry(node, entry, forms)) return true;
    return false;
  }

 private:
  bool in_scalar(const yaml::Node& node, const FormList& forms) {
    const std::size_t at = node.text.find(probe);
    if (at == std::string::npos) return false;
    cursor_.before = node.text.substr(0, at);
    cursor_.values = forms_.scalars(forms);
    static const yaml::Node nothing;  // the name may be the first key of a map
    if (!node.quoted && node.text == probe) cursor_.keys = forms_.maps(forms, nothing);
    return true;
  }

  bool in_entry(const yaml::Node& map, const yaml::Entry& entry, const FormList& forms) {
    const bool is_key = entry.key.find(probe) != std::string::npos;
    const FormList below = is_key ? FormList{} : forms_.under(forms, map, entry.key);
    const bool is_block =
        std::ranges::any_of(below, [](const yaml::Key* form) { return is_block_form(*form); });
    const std::string outer = cursor_.block;
    if (is_block) cursor_.block = entry.key;
    if (is_key) {
      cursor_.before = entry.key.substr(0, entry.key.find(probe));
      cursor_.keys = forms_.maps(forms, map);
    } else if (!find(entry.value, below)) {
      cursor_.block = outer;
      return false;
    }
    if (!cursor_.map) {
      cursor_.map = &map;
      cursor_.key = is_key ? "" : entry.key;
    }
    return true;
  }

  Forms& forms_;
  WritingPlace& cursor_;
};

TextRange word_around(std::string_view text, std::size_t offset) {
  TextRange word{offset, offset};
  while (word.from > 0 && is_in_name(text[word.from - 1])) --word.from;
  while (word.to < text.size() && is_in_name(text[word.to])) ++word.to;
  return word;
}

}  // namespace

std::optional<WritingPlace> writing_place(DiagramFiles& files, const std::string& file, std::size_t offset) {
  const auto text = files.texts().text(file);
  for (const std::string& probed : probed_texts(*text, std::min(offset, text->size()))) {
    try {
      WritingPlace cursor;
      cursor.document = std::make_shared<const yaml::Document>(yaml::parse_document(probed, file));
      Forms& forms = files.forms(file);
      if (!Search(forms, cursor).find(cursor.document->root, forms.root())) continue;
      cursor.word = word_around(*text, offset);
      cursor.scalar = {offset - std::min(offset, cursor.before.size()), cursor.word.to};
      return cursor;
    } catch (const yaml::Error&) {  // another trial text may be valid
    }
  }
  return std::nullopt;
}

}  // namespace stepwire::language
