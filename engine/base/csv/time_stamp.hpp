#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stepwire::csv {

/// A date and time in the Gregorian calendar without leap seconds.
struct TimeStamp {
  enum class Form : unsigned char {
    extended,  ///< of ISO 8601: 2026-11-27T10:00:00.250Z
    basic,     ///< of ISO 8601: 20261127T100000.250Z
    german     ///< DIN 5008: 27.11.2026 10:00:00,250
  };
  Form form = Form::extended;
  std::int64_t seconds = 0;      ///< since 1970, in UTC where there is a zone
  std::int64_t picoseconds = 0;  ///< 0 to below 1e12
  bool has_time = false, has_zone = false;
  char between = 'T';  ///< date and time: 'T' or ' '

  /// The two are written in one form; digits of fractions may differ, and offsets of zones.
  bool is_like(const TimeStamp& other) const {
    return form == other.form && has_time == other.has_time && has_zone == other.has_zone &&
           between == other.between;
  }
  /// [s], rounded once.
  double since(const TimeStamp& other) const;
};

/// Reads YYYY-MM-DD, with hh:mm, hh:mm:ss or a fraction after point or comma behind 'T' or a blank, and with
/// Z, +hh:mm, +hhmm or +hh; YYYYMMDDThhmm and YYYYMMDDThhmmss alike; and DD.MM.YYYY, with a time behind a
/// blank. Empty for others and for what no calendar has.
std::optional<TimeStamp> time_stamp(std::string_view text);
/// True for a text that is rather a date or time than a number or a word, also one that time_stamp() refuses.
bool looks_like_time(std::string_view text);

}  // namespace stepwire::csv
