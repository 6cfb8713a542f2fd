#include "engine/base/mat/mat_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace stepwire::mat {
namespace {

constexpr std::size_t longest_name = 63;

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// The name of a column as MATLAB allows it, and not one of `used`.
std::string matlab_name(const std::string& name, std::set<std::string>& used) {
  std::string allowed = name.empty() || !is_letter(name.front()) ? "x" : "";
  for (const char c : name) allowed += is_letter(c) || (c >= '0' && c <= '9') ? c : '_';
  allowed.resize(std::min(allowed.size(), longest_name));
  std::string unique = allowed;
  for (int i = 2; !used.insert(unique).second; ++i) {
    const std::string ending = fmt::format("_{}", i);
    unique = allowed.substr(0, longest_name - ending.size()) + ending;
  }
  return unique;
}

}  // namespace

std::vector<std::string> matlab_names(const std::vector<std::string>& columns) {
  std::set<std::string> used{"names",  "units",     "break",  "case",       "catch",    "continue",
                             "else",   "elseif",    "end",    "for",        "function", "global",
                             "if",     "otherwise", "parfor", "persistent", "return",   "spmd",
                             "switch", "try",       "while",  "classdef"};
  std::vector<std::string> names;
  for (const std::string& column : columns) names.push_back(matlab_name(column, used));
  return names;
}

}  // namespace stepwire::mat
