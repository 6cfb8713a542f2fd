#include "engine/app/simulink/plain_text.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace stepwire::simulink {

namespace {

std::string trimmed(std::string text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  while (!text.empty() && is_blank(text.back())) text.pop_back();
  std::size_t first = 0;
  while (first < text.size() && is_blank(text[first])) ++first;
  return text.substr(first);
}

/// Replaces the entities that annotations have.
std::string without_entities(std::string text) {
  constexpr std::pair<std::string_view, std::string_view> known[] = {
      {"&nbsp;", " "}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}};
  for (const auto& [entity, sign] : known)
    for (std::size_t at = 0; (at = text.find(entity, at)) != text.npos; at += sign.size())
      text.replace(at, entity.size(), sign);
  return text;
}

}  // namespace

std::string on_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool is_blank = static_cast<unsigned char>(c) <= ' ';
    if (!is_blank)
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  return trimmed(line);
}

std::string without_markup(const std::string& text) {
  if (text.find("<html") == text.npos && text.find("<!DOCTYPE") == text.npos && text.find("<p") == text.npos)
    return on_one_line(text);
  std::string plain;
  bool in_tag = false;
  std::string tag;
  bool in_style = false;
  for (const char c : text) {
    if (c == '<') {
      in_tag = true;
      tag.clear();
    } else if (c == '>' && in_tag) {
      in_tag = false;
      if (tag.starts_with("style")) in_style = true;
      if (tag.starts_with("/style")) in_style = false;
      plain += ' ';
    } else if (in_tag) {
      tag += c;
    } else if (!in_style) {
      plain += c;
    }
  }
  return on_one_line(without_entities(plain));
}

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    parts.push_back(trimmed(text.substr(at, end - at)));
    at = end + 1;
  }
  while (!parts.empty() && parts.back().empty()) parts.pop_back();
  return parts;
}

std::string valid_name(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool fits = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    if (fits)
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (name.size() > 1 && name.back() == '_') name.pop_back();
  if (name.empty()) name = "block";
  if (std::isdigit(static_cast<unsigned char>(name[0])) != 0) name = "_" + name;
  if (name == "time" || name == "all" || name == "pi" || name == "e") name += "_";
  return name;
}

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace stepwire::simulink
