#include "engine/base/yaml/yaml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "engine/base/text/characters.hpp"

namespace stepwire::yaml {
namespace {

constexpr std::size_t longest_in_brackets = 100;  // [characters] of a value in brackets

bool is_null(const std::string& text) {
  return text == "null" || text == "Null" || text == "NULL" || text == "~";
}

/// True where a text has the same meaning without quotes in every context.
bool is_plain(const std::string& text) {
  constexpr std::string_view special = ",[]{}:#\"'`\\", special_at_start = "&*!|>%@?- ";
  if (text.empty() || is_null(text) || text.back() == ' ') return false;
  const bool negative = text[0] == '-' && text.size() > 1 && (std::isalnum(text[1]) || text[1] == '.');
  return (negative || special_at_start.find(text[0]) == std::string::npos) &&
         std::all_of(text.begin(), text.end(),
                     [&](char c) { return c >= ' ' && c <= '~' && special.find(c) == std::string::npos; });
}

std::string in_quotes(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return text::visible(result) + '"';  // the escapes of visible() are valid in YAML
}

std::string scalar_text(const Node& node) {
  if (node.kind == Node::Kind::empty) return "~";
  return !node.quoted && is_plain(node.text) ? node.text : in_quotes(node.text);
}

std::string key_text(const std::string& key) {
  return (is_plain(key) ? key : in_quotes(key)) + ":";
}

class Writer {
 public:
  std::string write_line(const Node& root) {
    in_brackets(root, std::string::npos);
    return std::move(text_);
  }

  std::string write(const Node& root) {
    if (root.entries.empty() && root.items.empty()) {
      in_brackets(root, longest_in_brackets);
    } else {
      lines(root, 0);
    }
    return std::move(text_) + "\n";
  }

 private:
  void lines(const Node& node, std::size_t indent) {
    for (const Entry& entry : node.entries) line(key_text(entry.key), entry.value, indent);
    for (const Node& item : node.items) line("-", item, indent);
  }

  void line(const std::string& start, const Node& node, std::size_t indent) {
    if (!text_.empty()) text_ += '\n';
    text_.append(indent, ' ') += start;
    const std::size_t before = text_.size();
    text_ += ' ';
    if (in_brackets(node, before + longest_in_brackets)) return;
    text_.resize(before);
    lines(node, indent + 2);
  }

  /// Appends a value in flow style. Returns false, with a partial text, where it would exceed `most`
  /// characters.
  bool in_brackets(const Node& node, std::size_t most) {
    if (!node.is_list() && !node.is_map()) {
      text_ += scalar_text(node);
      return true;
    }
    text_ += node.is_map() ? '{' : '[';
    const char* between = "";
    const auto add = [&](const std::string& start, const Node& inner) {
      text_ += between + start;
      between = ", ";
      return in_brackets(inner, most) && text_.size() < most;
    };
    for (const Node& item : node.items)
      if (!add("", item)) return false;
    for (const Entry& entry : node.entries)
      if (!add(key_text(entry.key) + " ", entry.value)) return false;
    text_ += node.is_map() ? '}' : ']';
    return true;
  }

  std::string text_;
};

}  // namespace

std::string yaml_text(const Node& root) {
  return Writer().write(root);
}

std::string yaml_line(const Node& root) {
  return Writer().write_line(root);
}

}  // namespace stepwire::yaml
