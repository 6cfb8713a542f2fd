#include "engine/base/csv/time_stamp.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <chrono>

namespace stepwire::csv {
namespace {

constexpr std::int64_t per_second = 1'000'000'000'000;  // picoseconds

/// Cursor over a text that consumes pieces from its start.
class StampText {
 public:
  explicit StampText(std::string_view text) : rest_(text) {}

  bool empty() const { return rest_.empty(); }
  char next() const { return rest_.empty() ? '\0' : rest_.front(); }

  bool take(char wanted) {
    if (next() != wanted) return false;
    rest_.remove_prefix(1);
    return true;
  }

  /// Consumes a number of exactly this many digits; std::nullopt if there are fewer.
  std::optional<int> number(std::size_t digits) {
    if (digits_ahead() < digits) return std::nullopt;
    int value = 0;
    std::from_chars(rest_.data(), rest_.data() + digits, value);
    rest_.remove_prefix(digits);
    return value;
  }

  /// Consumes the digits of a fraction and returns picoseconds; digits after the twelfth are dropped.
  std::optional<std::int64_t> fraction() {
    const std::size_t digits = digits_ahead();
    if (digits == 0) return std::nullopt;
    std::int64_t value = 0;
    for (std::size_t i = 0; i < 12; ++i) value = 10 * value + (i < digits ? rest_[i] - '0' : 0);
    rest_.remove_prefix(digits);
    return value;
  }

 private:
  std::size_t digits_ahead() const { return std::min(rest_.find_first_not_of("0123456789"), rest_.size()); }

  std::string_view rest_;
};

/// Consumes `mark` (unless it is '\0') and a number of two digits up to `most`.
std::optional<int> part(StampText& pieces, char mark, int most) {
  if (mark != '\0' && !pieces.take(mark)) return std::nullopt;
  const auto value = pieces.number(2);
  return value && *value <= most ? value : std::nullopt;
}

/// Separators within a date and within a time; '\0' for none.
struct Marks {
  char date, time;
};

Marks marks_of(TimeStamp::Form form) {
  if (form == TimeStamp::Form::basic) return {'\0', '\0'};
  return {form == TimeStamp::Form::german ? '.' : '-', ':'};
}

/// Consumes a date and returns the days since 1970; a German date begins with its day.
std::optional<std::int64_t> take_date(StampText& pieces, TimeStamp::Form form) {
  const char mark = marks_of(form).date;
  const bool day_first = form == TimeStamp::Form::german;
  auto day = day_first ? part(pieces, '\0', 31) : std::nullopt;
  auto year = day_first ? std::nullopt : pieces.number(4);
  if (!day && !year) return std::nullopt;
  const auto month = part(pieces, mark, 12);
  if (!month) return std::nullopt;
  if (!day_first) day = part(pieces, mark, 31);
  if (day_first && pieces.take(mark)) year = pieces.number(4);
  if (!day || !year) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok()) return std::nullopt;
  return std::chrono::sys_days(date).time_since_epoch().count();
}

/// True where a part of a time in this form follows.
bool has_part(const StampText& pieces, char mark) {
  return mark == '\0' ? std::isdigit(static_cast<unsigned char>(pieces.next())) != 0 : pieces.next() == mark;
}

/// Consumes the minutes and seconds that follow the hours, as far as they are there.
bool take_minutes(StampText& pieces, TimeStamp& stamp) {
  const char mark = marks_of(stamp.form).time;
  const auto minutes = part(pieces, mark, 59);
  if (!minutes) return false;
  stamp.seconds += 60 * *minutes;
  if (!has_part(pieces, mark)) return true;
  const auto seconds = part(pieces, mark, 59);
  if (!seconds) return false;
  stamp.seconds += *seconds;
  if (!pieces.take('.') && !pieces.take(',')) return true;
  const auto fraction = pieces.fraction();
  stamp.picoseconds = fraction.value_or(0);
  return fraction.has_value();
}

/// Consumes a time. The hour 24 has neither minutes nor seconds; an hour alone belongs to a date of ISO 8601.
bool take_time(StampText& pieces, TimeStamp& stamp) {
  constexpr std::int64_t hour = 3600;
  const auto hours = part(pieces, '\0', 24);
  if (!hours) return false;
  const std::int64_t day = stamp.seconds;
  stamp.seconds += hour * *hours;
  const bool more = has_part(pieces, marks_of(stamp.form).time);
  if (more && !take_minutes(pieces, stamp)) return false;
  if (!more && stamp.form == TimeStamp::Form::german) return false;
  return *hours < 24 || (stamp.seconds == day + 24 * hour && stamp.picoseconds == 0);
}

bool take_zone(StampText& pieces, TimeStamp& stamp) {
  stamp.has_zone = true;
  pieces.take(' ');
  if (pieces.take('Z') || pieces.take('z')) return true;
  const int sign = pieces.next() == '-' ? -1 : 1;
  if (!pieces.take('+') && !pieces.take('-')) return false;
  const auto hours = part(pieces, '\0', 23);
  if (!hours) return false;
  const bool more = !pieces.empty();
  const auto minutes = more ? part(pieces, pieces.next() == ':' ? ':' : '\0', 59) : 0;
  if (!minutes) return false;
  stamp.seconds -= sign * (3600 * *hours + 60 * *minutes);
  return true;
}

}  // namespace

double TimeStamp::since(const TimeStamp& other) const {
  const auto whole = static_cast<long double>(seconds - other.seconds) * static_cast<long double>(per_second);
  const auto all = whole + static_cast<long double>(picoseconds - other.picoseconds);
  return static_cast<double>(all / static_cast<long double>(per_second));
}

namespace {

/// Returns the form of a text that may be a time. Eight digits alone are a number.
std::optional<TimeStamp::Form> form_of(std::string_view text) {
  if (text.size() >= 10 && text[4] == '-') return TimeStamp::Form::extended;
  if (text.size() >= 11 && text[8] == 'T') return TimeStamp::Form::basic;
  if (text.size() >= 10 && text[2] == '.' && text[5] == '.') return TimeStamp::Form::german;
  if (text.size() >= 8 && text[2] == ':' && text[5] == ':') return TimeStamp::Form::clock;
  return std::nullopt;
}

/// Consumes a time without a date.
std::optional<TimeStamp> clock_time(StampText pieces) {
  TimeStamp stamp;
  stamp.form = TimeStamp::Form::clock;
  stamp.has_time = true;
  return take_time(pieces, stamp) && pieces.empty() ? std::optional(stamp) : std::nullopt;
}

}  // namespace

std::optional<TimeStamp> time_stamp(std::string_view text) {
  const auto form = form_of(text);
  if (!form) return std::nullopt;
  StampText pieces(text);
  if (*form == TimeStamp::Form::clock) return clock_time(pieces);
  TimeStamp stamp;
  stamp.form = *form;
  const auto days = take_date(pieces, *form);
  if (!days) return std::nullopt;
  stamp.seconds = *days * 86'400;
  if (pieces.empty()) return stamp;
  stamp.between = pieces.next();
  stamp.has_time = true;
  if (!(*form != TimeStamp::Form::german && pieces.take('T')) && !pieces.take(' ')) return std::nullopt;
  if (!take_time(pieces, stamp)) return std::nullopt;
  if (!pieces.empty() && !take_zone(pieces, stamp)) return std::nullopt;
  return pieces.empty() ? std::optional(stamp) : std::nullopt;
}

bool looks_like_time(std::string_view text) {
  const auto count = [&](std::string_view marks) {
    return std::ranges::count_if(text, [&](char c) { return marks.find(c) != marks.npos; });
  };
  const bool begins = !text.empty() && std::isdigit(static_cast<unsigned char>(text.front()));
  return begins && text.find_first_not_of("0123456789-/.,:+ TZapmAPM") == text.npos &&
         (count(":") > 0 || count("/") == 2 || count("-") == 2 || count(".") == 2);
}

}  // namespace stepwire::csv
