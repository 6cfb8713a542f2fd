#include "engine/base/csv/time_stamp.hpp"

#include <catch2/catch.hpp>

namespace stepwire::csv {

namespace {

double seconds(const char* from, const char* to) {
  return time_stamp(to).value().since(time_stamp(from).value());
}

}  // namespace

// Seconds since 1970 of: date -u -d 2026-11-27T10:00:00Z +%s (GNU coreutils 9.1), and others alike.
TEST_CASE("a time of ISO 8601 is its seconds since 1970") {
  CHECK(time_stamp("2026-11-27T10:00:00Z")->seconds == 1795773600);
  CHECK(time_stamp("2026-11-27 10:00:00")->seconds == 1795773600);
  CHECK(time_stamp("2026-11-27T10:00")->seconds == 1795773600);
  CHECK(time_stamp("2026-11-27")->seconds == 1795737600);
  CHECK(time_stamp("2026-11-27T12:00:00+02:00")->seconds == 1795773600);
  CHECK(time_stamp("2026-11-27T04:30:00-0530")->seconds == 1795773600);
  CHECK(time_stamp("2026-11-27 11:00:00+01")->seconds == 1795773600);
  CHECK(time_stamp("2026-11-27 11:00:00 +0100")->seconds == 1795773600);
  CHECK(time_stamp("2026-11-27 10:00:00 Z")->seconds == 1795773600);
  CHECK(time_stamp("2026-11-27T10")->seconds == 1795773600);
  CHECK(time_stamp("2026-11-27T10Z")->seconds == 1795773600);
  CHECK(time_stamp("20261127T10")->seconds == 1795773600);
  CHECK(time_stamp("2026-11-26T24:00:00Z")->seconds == 1795737600);
  CHECK(time_stamp("2026-11-26T24:00")->seconds == 1795737600);
  CHECK(time_stamp("20261126T240000,0")->seconds == 1795737600);
  CHECK(time_stamp("2024-02-29T00:00:00Z")->seconds == 1709164800);
  CHECK(time_stamp("1969-12-31T23:59:59Z")->seconds == -1);
}

TEST_CASE("the basic form of ISO 8601 and German dates are the same times") {
  CHECK(time_stamp("20261127T100000Z")->seconds == 1795773600);
  CHECK(time_stamp("20261127T1000")->seconds == 1795773600);
  CHECK(time_stamp("20261127T120000+0200")->seconds == 1795773600);
  CHECK(time_stamp("27.11.2026 10:00:00")->seconds == 1795773600);
  CHECK(time_stamp("27.11.2026 10:00")->seconds == 1795773600);
  CHECK(time_stamp("27.11.2026")->seconds == 1795737600);
  CHECK(time_stamp("29.02.2024")->seconds == 1709164800);
  CHECK(seconds("20261127T100000", "20261127T100000.25") == 0.25);
  CHECK(seconds("27.11.2026 23:59:59,9", "28.11.2026 00:00:00,1") == 0.2);
  CHECK_FALSE(time_stamp("27.11.2026 10:00:00")->is_like(*time_stamp("2026-11-27 10:00:00")));
  CHECK_FALSE(time_stamp("20261127T100000")->is_like(*time_stamp("2026-11-27T10:00:00")));
}

TEST_CASE("a text that may be meant as a time is told from a number and a word") {
  for (const char* text : {"11/27/2026 10:00:00", "7.11.2026", "27.11.26 10:00", "10:00:00", "2026-1-2"})
    CHECK(looks_like_time(text));
  for (const char* text : {"1.5", "1,000.5", "-3", "1e-5", "no", "", "12 mm"})
    CHECK_FALSE(looks_like_time(text));
}

TEST_CASE("differences of times are rounded once, over days and in their last digits") {
  CHECK(seconds("2026-11-27T10:00:00.1Z", "2026-11-27T10:00:00.3Z") == 0.2);
  CHECK(seconds("2026-11-27T10:00:00Z", "2026-11-27T10:00:00.250Z") == 0.25);
  CHECK(seconds("2026-12-31T23:59:59,999999", "2027-01-01T00:00:00,000001") == 2e-6);
  CHECK(seconds("2000-01-01T00:00:00Z", "2026-11-27T10:00:00.1Z") == 849088800.1);
  CHECK(seconds("2026-11-27T10:00:01Z", "2026-11-27T10:00:00.5Z") == -0.5);
}

TEST_CASE("what no calendar has and what is written otherwise is no time") {
  for (const char* text : {"2026-02-29T00:00:00Z",
                           "2026-13-01",
                           "2026-00-10",
                           "2026-11-31",
                           "2026-11-27T24:00:01",
                           "2026-11-27T24:00:00.1",
                           "2026-11-27T24:30",
                           "2026-11-27T25:00:00",
                           "2026-11-27T10:60:00",
                           "2026-11-27T10:00:60",
                           "2026-11-27T1",
                           "27.11.2026 10",
                           "10:00",
                           "10:00:00Z",
                           "10:60:00",
                           "2026-11-27T10:00:00.",
                           "2026-11-27T10:00:00 ",
                           "2026-11-27T10:00:00  Z",
                           "2026-11-27T10:00:00+2",
                           "2026-11-27x",
                           "27.11.2026T10:00:00",
                           "29.02.2026",
                           "27.13.2026 10:00:00",
                           "7.11.2026 10:00:00",
                           "27.11.26 10:00",
                           "11/27/2026 10:00:00",
                           "20261127",
                           "20261127T10:00:00",
                           "20261127T1000001",
                           "2026-11-27T100000",
                           "20260229T100000",
                           "2026-1-2",
                           "2026",
                           ""}) {
    INFO(text);
    CHECK_FALSE(time_stamp(text).has_value());
  }
}

TEST_CASE("times are of one form where zone and separator agree, whatever their digits") {
  const TimeStamp zoned = *time_stamp("2026-11-27T10:00:00Z");
  CHECK(zoned.is_like(*time_stamp("2026-11-27T10:00:00.123+01:00")));
  CHECK_FALSE(zoned.is_like(*time_stamp("2026-11-27T10:00:00")));
  CHECK_FALSE(zoned.is_like(*time_stamp("2026-11-27 10:00:00Z")));
  CHECK_FALSE(time_stamp("2026-11-27")->is_like(*time_stamp("2026-11-27T10:00:00")));
}

}  // namespace stepwire::csv
