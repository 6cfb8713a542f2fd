#include "engine/simulate/codegen/cpp_words.hpp"

#include <fmt/format.h>

#include "engine/base/text/characters.hpp"

namespace stepwire::codegen {

namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

void part(std::string& text, std::string_view word, const std::string& parted) {
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += parted.size())
    text.replace(at, word.size(), parted);
}

}  // namespace

std::string cpp_comment(std::string_view text) {
  std::string result = text::visible(text);
  part(result, "?\?/", "? ?/");  // trigraph of a backslash
  part(result, "*/", "* /");
  part(result, "/*", "/ *");
  result.erase(result.find_last_not_of(' ') + 1);
  return result.ends_with('\\') ? result + "." : result;
}

std::string cpp_identifier(std::string_view name) {
  std::string result;
  for (const char c : name) result += is_letter(c) || is_digit(c) ? c : '_';
  const bool begins_well = !result.empty() && !is_digit(result.front());
  return begins_well ? result : "_" + result;
}

std::string free_member(std::string_view name, std::set<std::string>& taken) {
  const std::string first = cpp_identifier(name) + "_";
  std::string own = first;
  for (int number = 2; !taken.insert(own).second; ++number) own = fmt::format("{}{}_", first, number);
  return own;
}

std::string cpp_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    // An octal escape has at most three digits, whereas a hexadecimal one has no limit.
    const bool plain = is_letter(c) || is_digit(c) ||
                       std::string_view(" !#$%&'()*+,-./:;<=>@[]^_`{|}~").find(c) != std::string_view::npos;
    result += plain ? std::string(1, c) : fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  }
  return result + '"';
}

}  // namespace stepwire::codegen
