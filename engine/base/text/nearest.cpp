#include "engine/base/text/nearest.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace stepwire::text {
namespace {

constexpr std::size_t longest_word = 64;  // bounds the cost of the distance, O(product of both lengths)

std::string lower(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

// Optimal string alignment distance: insertions, deletions, replacements and swaps of neighbours cost one
// each. Words have at most longest_word letters; distances of at least `most` are returned as `most`.
std::size_t distance(const std::string& a, const std::string& b, std::size_t most) {
  if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) >= most) return most;
  std::array<std::array<std::size_t, longest_word + 1>, 3> rows;
  const auto row = [&](std::size_t i) -> auto& {
    return rows[i % 3];
  };
  for (std::size_t j = 0; j <= b.size(); ++j) row(0)[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row(i)[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row(i)[j] = std::min(
          {row(i - 1)[j] + 1, row(i)[j - 1] + 1, row(i - 1)[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row(i)[j] = std::min(row(i)[j], row(i - 2)[j - 2] + 1);
    }
  }
  return std::min(row(a.size())[b.size()], most);
}

/// Returns the lower-case initials of a CamelCase name, "zoh" of "ZeroOrderHold"; empty for other names.
std::string initials(const std::string& name) {
  std::string result;
  for (const char c : name)
    if (std::isupper(static_cast<unsigned char>(c))) result += c;
  return lower(result);
}

// True where a word is a prefix, the last part or the initials of a name. So "freq" suggests "frequency",
// "coulomb" and "force" suggest "coulomb_force", and "ZOH" suggests "ZeroOrderHold".
bool abbreviates(const std::string& word, const std::string& name) {
  if (word.size() < 3) return false;
  return lower(name).starts_with(word) || name.ends_with("_" + word) || initials(name) == word;
}

}  // namespace

const std::string* nearest(const std::string& word, const std::vector<std::string>& names) {
  if (word.empty() || word.size() > longest_word) return nullptr;
  const std::string wanted = lower(word);
  const std::size_t near = std::max<std::size_t>(1, word.size() / 3);
  const std::string* nearest = nullptr;
  std::size_t least = near + 1;
  for (const std::string& name : names) {
    if (name == word || name.size() > longest_word) continue;
    std::size_t far = distance(wanted, lower(name), near + 1);
    if (far > near && abbreviates(wanted, name)) far = near;
    // A name that shares no letter in place is not a suggestion.
    if (far >= least || far >= std::max(word.size(), name.size())) continue;
    least = far;
    nearest = &name;
  }
  return nearest;
}

std::string or_nearest(const std::string& word, const std::vector<std::string>& names) {
  const std::string* const found = nearest(word, names);
  return found ? "; did you mean '" + *found + "'?" : "";
}

}  // namespace stepwire::text
