#include "engine/simulate/realtime/deadlines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace stepwire::realtime {

std::optional<Overrun> parse_overrun(std::string_view text) {
  if (text == "skip") return Overrun{Overrun::Kind::skip, 0};
  if (text == "catch-up") return Overrun{Overrun::Kind::catch_up, 0};
  if (!text.starts_with("stop:")) return std::nullopt;
  text.remove_prefix(5);
  Overrun overrun{Overrun::Kind::stop, 0};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), overrun.misses);
  if (error != std::errc() || end != text.data() + text.size() || overrun.misses < 1) return std::nullopt;
  return overrun;
}

std::string overrun_text(const Overrun& overrun) {
  if (overrun.kind == Overrun::Kind::stop) return "stop:" + std::to_string(overrun.misses);
  return overrun.kind == Overrun::Kind::skip ? "skip" : "catch-up";
}

std::int64_t Deadlines::at(std::int64_t k) const {
  return start_ + std::llround(static_cast<long double>(k) * period_);
}

void Deadlines::miss() {
  longest_row_.set(std::max(longest_row_.get(), ++row_));
}

std::int64_t Deadlines::drop_missed(std::int64_t now, std::int64_t end) {
  if (overrun_.kind == Overrun::Kind::catch_up) return 0;
  std::int64_t count = 0;
  for (; index_ < end && at(index_ + 1) <= now; index_.add(), ++count) miss();
  dropped_.add(count);
  return count;
}

void Deadlines::served(std::int64_t written) {
  if (written < at(index_ + 1)) {
    row_ = 0;
  } else {
    late_.add();
    miss();
  }
  index_.add();
}

}  // namespace stepwire::realtime
