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
    german,    ///< DIN 5008: 27.11.2026 10:00:00,250
    clock      ///< without a date: 10:00:00.250, on the first day of 1970
  };
  Form form = Form::extended;
  std::int64_t seconds = 0;      ///< since 1970, in UTC if the text has a zone
  std::int64_t picoseconds = 0;  ///< in [0, 1e12)
  bool has_time = false, has_zone = false;
  char between = 'T';  ///< separator of date and time: 'T' or ' '

  /// True where both have the same form; the digits of fractions and the offsets of zones may differ.
  bool is_like(const TimeStamp& other) const {
    return form == other.form && has_time == other.has_time && has_zone == other.has_zone &&
           between == other.between;
  }
  /// Returns the difference to another time [s], rounded once.
  double since(const TimeStamp& other) const;
};

/// Parses YYYY-MM-DD, optionally with hh, hh:mm, hh:mm:ss or a fraction after point or comma behind 'T' or a
/// blank. A zone may follow, also behind a blank: Z, +hh:mm, +hhmm or +hh. Parses also YYYYMMDDThh,
/// YYYYMMDDThhmm and YYYYMMDDThhmmss, DD.MM.YYYY with a time behind a blank, and hh:mm:ss alone. 24:00:00 is
/// the end of its day. Returns std::nullopt for other texts and for dates that do not exist.
std::optional<TimeStamp> time_stamp(std::string_view text);
/// True for a text that resembles a date or time more than a number or a word, even if time_stamp() refuses
/// it.
bool looks_like_time(std::string_view text);

}  // namespace stepwire::csv
