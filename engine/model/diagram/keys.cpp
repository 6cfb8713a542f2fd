#include "engine/model/diagram/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace stepwire {

bool refuse_unknown_keys(const Node& map, const std::vector<std::string>& known, const std::string& subject,
                         const Scope& scope, Report& report) {
  bool found = false;
  for (const Entry& entry : map.entries) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    found = true;
    // "{max: limit, x > 2}" is read by YAML as a key of its own: the piece of an expression that a comma cut
    // off.
    const bool looks_cut = entry.key.find_first_of("<>=&|()+*/ ") != std::string::npos;
    const std::string all = fmt::format("Known are: {}", fmt::join(known, ", "));
    const std::string cure = looks_cut
                                 ? "; if it belongs to an expression, quote the whole expression. " + all
                                 : did_you_mean(entry.key, known, all);
    report.add(scope.at(entry.mark), subject, fmt::format("there is no key '{}' here{}", entry.key, cure));
  }
  return found;
}

std::string read_text(const Node& node, const std::string& subject, const Scope& scope, Report& report) {
  if (!node.is_scalar()) report.add(scope.at(node.mark), subject, "a text is wanted here");
  return node.text;
}

bool read_flag(const Node& node, const std::string& subject, const Scope& scope, Report& report) {
  if (node.is_scalar() && (node.text == "true" || node.text == "false")) return node.text == "true";
  report.add(scope.at(node.mark), subject, fmt::format("'{}' is neither true nor false", node.text));
  return false;
}

bool is_name(const std::string& text) {
  const auto letter = [](unsigned char c) { return std::isalpha(c) || c == '_'; };
  return !text.empty() && letter(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(), [&](unsigned char c) { return letter(c) || std::isdigit(c); });
}

bool is_dotted_name(const std::string& text) {
  for (std::size_t first = 0;;) {
    const std::size_t dot = text.find('.', first);
    if (!is_name(text.substr(first, dot - first))) return false;
    if (dot == std::string::npos) return true;
    first = dot + 1;
  }
}

}  // namespace stepwire
