#include "engine/base/mat/mat_names.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace stepwire::mat {
namespace {

constexpr std::size_t longest_name = 63;

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Returns the name of a column with the characters that MATLAB allows.
std::string allowed_name(const std::string& name) {
  std::string allowed = name.empty() || !is_letter(name.front()) ? "x" : "";
  for (const char c : name) allowed += is_letter(c) || (c >= '0' && c <= '9') ? c : '_';
  allowed.resize(std::min(allowed.size(), longest_name));
  return allowed;
}

/// Set of used names; a name that is taken gets a number appended.
class Taken {
 public:
  explicit Taken(std::set<std::string> names) : names_(std::move(names)) {}

  std::string unique(const std::string& name) {
    if (names_.insert(name).second) return name;
    for (std::size_t digits = 1, first = 2, end = 10;; ++digits, first = end, end *= 10) {
      const std::string stem = name.substr(0, longest_name - 1 - digits) + '_';
      // Numbers below this one are taken, so that no name is tried twice.
      std::size_t& next = next_.try_emplace({stem, digits}, first).first->second;
      while (next < end)
        if (std::string numbered = stem + std::to_string(next++); names_.insert(numbered).second)
          return numbered;
    }
  }

 private:
  std::set<std::string> names_;
  std::map<std::pair<std::string, std::size_t>, std::size_t> next_;  ///< by stem and number of digits
};

}  // namespace

std::vector<std::string> matlab_names(const std::vector<std::string>& columns) {
  Taken taken({"names",  "units", "break",    "case",   "catch", "continue",  "else",   "elseif",
               "end",    "for",   "function", "global", "if",    "otherwise", "parfor", "persistent",
               "return", "spmd",  "switch",   "try",    "while", "classdef"});
  std::vector<std::string> names;
  for (const std::string& column : columns) names.push_back(taken.unique(allowed_name(column)));
  return names;
}

}  // namespace stepwire::mat
