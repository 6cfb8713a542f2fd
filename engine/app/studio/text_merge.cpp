// Three-way merge by lines, as diff3 does: the differences of each text to the base follow from a longest
// common subsequence of lines. Differences of the two texts that touch form one region. A region that both
// change in different ways is a conflict. Source: S. Khanna, K. Kunal, B. C. Pierce, "A formal investigation
// of diff3", FSTTCS 2007. Cost: time and memory grow with the product of the numbers of lines, without the
// common head and tail.
#include "engine/app/studio/text_merge.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "engine/app/studio/fault.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::studio {
namespace {

/// Returns the UTF-16 units of a UTF-8 character; those of four bytes take two units.
std::size_t units_of(std::size_t bytes) {
  return bytes == 4 ? 2 : 1;
}

/// Forward cursor from UTF-16 places to bytes.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {}

  /// Returns the byte offset of a place, which must not be before the previous one.
  std::size_t byte_at(std::size_t place) {
    while (units_ < place && byte_ < text_.size()) {
      const std::size_t length = std::max<std::size_t>(1, text::utf8_length(text_.substr(byte_)));
      byte_ += length;
      units_ += units_of(length);
    }
    if (units_ != place) throw Fault("a change lies outside of the text or inside of a character");
    return byte_;
  }

 private:
  std::string_view text_;
  std::size_t byte_ = 0, units_ = 0;
};

using Lines = std::vector<std::string_view>;  // each with its line end

constexpr std::size_t most_lines = 3000;  // limit without common head and tail; beyond it all lines differ

Lines lines_of(std::string_view text) {
  Lines lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    lines.push_back(text.substr(at, end - at));
    at = end;
  }
  return lines;
}

/// Lines [from, to) of the base are lines [first, last) of the other text.
struct Hunk {
  std::size_t from = 0, to = 0, first = 0, last = 0;

  bool inserts() const { return from == to; }
};

/// Returns a longest common subsequence of lines, as pairs of indices.
std::vector<std::pair<std::size_t, std::size_t>> common(std::span<const std::string_view> a,
                                                        std::span<const std::string_view> b) {
  if (a.size() > most_lines || b.size() > most_lines) return {};
  const std::size_t width = b.size() + 1;
  std::vector<std::uint16_t> length((a.size() + 1) * width);
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      length[i * width + j] = a[i] == b[j] ? static_cast<std::uint16_t>(length[(i + 1) * width + j + 1] + 1)
                                           : std::max(length[(i + 1) * width + j], length[i * width + j + 1]);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i] == b[j])
      pairs.emplace_back(i++, j++);
    else if (length[(i + 1) * width + j] >= length[i * width + j + 1])
      ++i;
    else
      ++j;
  }
  return pairs;
}

std::vector<std::pair<std::size_t, std::size_t>> equal_lines(const Lines& a, const Lines& b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  std::size_t begin = 0, end = 0;
  while (begin < shorter && a[begin] == b[begin]) ++begin;
  while (end < shorter - begin && a[a.size() - 1 - end] == b[b.size() - 1 - end]) ++end;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < begin; ++i) pairs.emplace_back(i, i);
  const auto middle = [&](const Lines& lines) {
    return std::span(lines).subspan(begin, lines.size() - begin - end);
  };
  for (const auto& [i, j] : common(middle(a), middle(b))) pairs.emplace_back(begin + i, begin + j);
  for (std::size_t i = end; i > 0; --i) pairs.emplace_back(a.size() - i, b.size() - i);
  return pairs;
}

std::vector<Hunk> hunks_of(const Lines& base, const Lines& other) {
  std::vector<Hunk> hunks;
  std::size_t i = 0, j = 0;
  auto pairs = equal_lines(base, other);
  pairs.emplace_back(base.size(), other.size());
  for (const auto& [next_i, next_j] : pairs) {
    if (next_i > i || next_j > j) hunks.push_back({i, next_i, j, next_j});
    i = next_i + 1;
    j = next_j + 1;
  }
  return hunks;
}

bool touch(const Hunk& a, const Hunk& b) {
  if (a.inserts() || b.inserts()) return a.from <= b.to && b.from <= a.to;
  return a.from < b.to && b.from < a.to;
}

/// One text of a merge, with a cursor in its hunks.
struct Side {
  const Lines& lines;
  std::vector<Hunk> hunks;
  std::size_t next = 0;
  std::ptrdiff_t shift = 0;  ///< line of this text minus line of the base, behind the taken hunks

  const Hunk* peek() const { return next < hunks.size() ? &hunks[next] : nullptr; }

  /// Takes all hunks that touch a region, and extends the region by them.
  bool take(Hunk& region, std::vector<Hunk>& taken) {
    bool any = false;
    while (peek() && touch(*peek(), region)) {
      region.from = std::min(region.from, peek()->from);
      region.to = std::max(region.to, peek()->to);
      taken.push_back(hunks[next++]);
      any = true;
    }
    return any;
  }
  /// Returns the lines of this text for a region of the base whose hunks are taken.
  std::pair<std::size_t, std::size_t> range(const Hunk& region, const std::vector<Hunk>& taken) {
    const std::ptrdiff_t before = shift;
    for (const Hunk& one : taken)
      shift += std::ptrdiff_t(one.last - one.first) - std::ptrdiff_t(one.to - one.from);
    return {static_cast<std::size_t>(std::ptrdiff_t(region.from) + before),
            static_cast<std::size_t>(std::ptrdiff_t(region.to) + shift)};
  }
  std::string text(const std::pair<std::size_t, std::size_t>& range) const {
    std::string text;
    for (std::size_t i = range.first; i < range.second; ++i) text += lines[i];
    return text;
  }
};

/// Returns the lines as YAML comments with the same indentation.
std::string as_comments(std::string_view text) {
  std::string comments;
  for (const std::string_view line : lines_of(text)) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos || line[first] == '\n') continue;
    comments += std::string(line.substr(0, first)) + "# in the file: " + std::string(line.substr(first));
  }
  return comments;
}

class Merging {
 public:
  Merging(const Lines& base, const Lines& ours, const Lines& theirs)
      : ours_{ours, hunks_of(base, ours)}, theirs_{theirs, hunks_of(base, theirs)} {
    std::size_t at = 0;
    for (const std::string_view line : ours) places_.push_back(std::exchange(at, at + utf16_length(line)));
    places_.push_back(at);
  }

  TextMerge done() {
    while (ours_.peek() || theirs_.peek()) region();
    return std::move(merge_);
  }

 private:
  void region() {
    const Hunk *a = ours_.peek(), *b = theirs_.peek();
    const bool is_ours_first = a && (!b || a->from < b->from || (a->from == b->from && a->to < b->to));
    Hunk region = is_ours_first ? *a : *b;
    std::vector<Hunk> mine, other;
    (is_ours_first ? mine : other).push_back(region);
    ++(is_ours_first ? ours_ : theirs_).next;
    for (bool grows = true; grows;) {
      grows = ours_.take(region, mine);
      grows = theirs_.take(region, other) || grows;
    }
    const auto range = ours_.range(region, mine);
    const std::string theirs = theirs_.text(theirs_.range(region, other));
    if (other.empty()) return;
    if (mine.empty()) return put(range.first, range.second, theirs);
    const std::string ours = ours_.text(range);
    if (ours == theirs) return;
    merge_.is_clean = false;
    const bool has_end = ours.empty() || ours.ends_with('\n');
    put(range.second, range.second, (has_end ? "" : "\n") + as_comments(theirs));
  }

  void put(std::size_t from, std::size_t to, std::string text) {
    merge_.changes.push_back({places_[from], places_[to], std::move(text)});
  }

  Side ours_, theirs_;
  std::vector<std::size_t> places_;  ///< starts of our lines [UTF-16]
  TextMerge merge_;
};

}  // namespace

std::size_t utf16_length(std::string_view text) {
  std::size_t units = 0;
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(1, text::utf8_length(text));
    text.remove_prefix(length);
    units += units_of(length);
  }
  return units;
}

std::string changed(std::string_view text, std::vector<TextChange> changes) {
  std::ranges::stable_sort(changes, {}, &TextChange::from);
  Walk walk(text);
  std::string result;
  std::size_t done = 0, last = 0;
  for (const TextChange& change : changes) {
    if (change.from < last || change.to < change.from) throw Fault("two changes overlap");
    last = change.to;
    const std::size_t from = walk.byte_at(change.from), to = walk.byte_at(change.to);
    result.append(text, done, from - done).append(change.text);
    done = to;
  }
  return result.append(text, done);
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = text::utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

TextMerge merge(std::string_view base, std::string_view ours, std::string_view theirs) {
  const Lines from = lines_of(base), mine = lines_of(ours), other = lines_of(theirs);
  return Merging(from, mine, other).done();
}

TextMerge merge(std::string_view ours, std::string_view theirs) {
  std::string base;
  const Lines mine = lines_of(ours), other = lines_of(theirs);
  for (const auto& [i, j] : equal_lines(mine, other)) base += mine[i];
  TextMerge merged = merge(base, ours, theirs);
  merged.is_clean = false;
  return merged;
}

}  // namespace stepwire::studio
