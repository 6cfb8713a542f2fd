#include "engine/app/studio/line_ends.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

namespace stepwire::studio {

namespace {

constexpr std::ptrdiff_t most_edits = 1000;  // limit of removed and added lines; beyond it all lines between
                                             // head and tail are new

struct Line {
  std::string_view text;
  std::string_view end;  ///< empty for a last line without end
};

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  while (!text.empty()) {
    const std::size_t at = text.find('\n');
    if (at == std::string_view::npos) {
      lines.push_back({text, {}});
      break;
    }
    const std::size_t end = at > 0 && text[at - 1] == '\r' ? at - 1 : at;
    lines.push_back({text.substr(0, end), text.substr(end, at + 1 - end)});
    text.remove_prefix(at + 1);
  }
  return lines;
}

std::string_view usual_end(const std::vector<Line>& lines) {
  const auto long_ends = std::ranges::count(lines, "\r\n", &Line::end);
  return long_ends > std::ranges::count(lines, "\n", &Line::end) ? "\r\n" : "\n";
}

/// Alignment of the lines of `now` with those of `before`, with the fewest removed and added lines. Source:
/// E. W. Myers, "An O(ND) Difference Algorithm and Its Variations", Algorithmica 1, 1986. The common head and
/// tail are cut off first. Then forward() extends paths on the diagonals k = x - y, with one more edit in
/// each round, until one reaches the end. Afterwards back() retraces that path through the stored frontiers.
/// Cost with N lines and D edits: O(ND) time, O(D^2) memory. D is at most most_edits.
class Pairs {
 public:
  Pairs(const std::vector<Line>& before, const std::vector<Line>& now) : before_(before), now_(now) {
    of_now.resize(now.size());
    const std::ptrdiff_t head = common_head(), tail = common_tail(head);
    for (std::ptrdiff_t i = 0; i < head; ++i) of_now[index(i)] = i;
    for (std::ptrdiff_t i = 1; i <= tail; ++i) of_now[now.size() - index(i)] = std::ssize(before) - i;
    first_ = head;
    n_ = std::ssize(before) - head - tail;
    m_ = std::ssize(now) - head - tail;
    if (forward()) back();
  }

  std::vector<std::optional<std::ptrdiff_t>> of_now;

 private:
  static std::size_t index(std::ptrdiff_t i) { return static_cast<std::size_t>(i); }
  bool same(std::ptrdiff_t b, std::ptrdiff_t n) const {
    return before_[index(b)].text == now_[index(n)].text;
  }

  std::ptrdiff_t common_head() const {
    const std::ptrdiff_t most = std::min(std::ssize(before_), std::ssize(now_));
    std::ptrdiff_t head = 0;
    while (head < most && same(head, head)) ++head;
    return head;
  }
  std::ptrdiff_t common_tail(std::ptrdiff_t head) const {
    const std::ptrdiff_t most = std::min(std::ssize(before_), std::ssize(now_)) - head;
    std::ptrdiff_t tail = 0;
    while (tail < most && same(std::ssize(before_) - tail - 1, std::ssize(now_) - tail - 1)) ++tail;
    return tail;
  }

  /// Returns the x at which the path of d edits enters diagonal k = x - y, from the frontier `last` of d - 1
  /// edits.
  std::ptrdiff_t reach(const std::vector<std::ptrdiff_t>& last, std::ptrdiff_t d, std::ptrdiff_t k) const {
    const auto at = [&](std::ptrdiff_t diagonal) { return last[index(diagonal + d)]; };
    if (d == 0) return 0;
    const bool added = k == -d || (k != d && at(k - 1) < at(k + 1));
    return added ? at(k + 1) : at(k - 1) + 1;
  }

  /// Stores the frontier of each number of edits; false if more than most_edits are needed.
  bool forward() {
    for (std::ptrdiff_t d = 0; d <= std::min(n_ + m_, most_edits); ++d) {
      static const std::vector<std::ptrdiff_t> none;
      std::vector<std::ptrdiff_t> reached(index(2 * d + 3), -1);  // diagonals -d-1 to d+1
      const std::vector<std::ptrdiff_t>& last = ways_.empty() ? none : ways_.back();
      for (std::ptrdiff_t k = -d; k <= d; k += 2) {
        std::ptrdiff_t x = reach(last, d, k);
        while (x < n_ && x - k < m_ && x >= k && same(first_ + x, first_ + x - k)) ++x;
        reached[index(k + d + 1)] = x;
        if (x >= n_ && x - k >= m_) {
          end_ = d;
          return true;
        }
      }
      ways_.push_back(std::move(reached));
    }
    return false;
  }

  void back() {
    std::ptrdiff_t x = n_, y = m_;
    for (std::ptrdiff_t d = end_; d >= 0; --d) {
      const std::ptrdiff_t k = x - y;
      const std::ptrdiff_t begin = d == 0 ? 0 : reach(ways_[index(d - 1)], d, k);
      for (; x > begin; --x, --y) of_now[index(first_ + y - 1)] = first_ + x - 1;
      if (d == 0) return;
      const auto& last = ways_[index(d - 1)];
      const bool added = k == -d || (k != d && last[index(k - 1 + d)] < last[index(k + 1 + d)]);
      added ? --y : --x;
    }
  }

  const std::vector<Line>&before_, &now_;
  std::ptrdiff_t first_ = 0, n_ = 0, m_ = 0, end_ = 0;
  std::vector<std::vector<std::ptrdiff_t>> ways_;
};

}  // namespace

std::string with_line_ends_of(const std::string& file, const std::string& text) {
  const std::vector<Line> before = lines_of(file), now = lines_of(text);
  const std::string_view usual = usual_end(before);
  if (std::ranges::all_of(before, [&](const Line& line) { return line.end.empty() || line.end == usual; }) &&
      usual == "\n")
    return text;
  const Pairs pairs(before, now);
  std::string result;
  for (std::size_t i = 0; i < now.size(); ++i) {
    result += now[i].text;
    if (now[i].end.empty()) continue;
    const auto& pair = pairs.of_now[i];
    const std::string_view own = pair ? before[static_cast<std::size_t>(*pair)].end : "";
    result += own.empty() ? usual : own;
  }
  return result;
}

}  // namespace stepwire::studio
