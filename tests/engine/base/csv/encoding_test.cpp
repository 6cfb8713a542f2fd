#include "engine/base/csv/encoding.hpp"

#include <catch2/catch.hpp>

#include "engine/base/csv/read_record.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::csv {

namespace {

/// A text of 16-bit units as a file has it.
std::string utf16(const std::u16string& text, bool big, bool mark = true) {
  std::string bytes;
  for (const char16_t unit : (mark ? u"\xFEFF" : u"") + text) {
    const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
    bytes += big ? high : low;
    bytes += big ? low : high;
  }
  return bytes;
}

}  // namespace

TEST_CASE("UTF-16 of either byte order becomes UTF-8, also beyond 16 bits") {
  const std::u16string text = u"t;\u00B5x \u20AC \U0001F600\n";
  const std::string utf8 = "t;\xC2\xB5x \xE2\x82\xAC \xF0\x9F\x98\x80\n";
  for (const bool big : {false, true})
    for (const bool mark : {false, true}) CHECK(decode(utf16(text, big, mark)).text == utf8);
  CHECK(decode(utf16(text, false)).encoding == "UTF-16 (little endian)");
  CHECK(decode(utf16(text, true)).encoding == "UTF-16 (big endian)");
  CHECK(decode(utf16(u"a\xD83D"
                     u"b",
                     false))
            .text ==
        "a\xEF\xBF\xBD"
        "b");  // half of a character
}

TEST_CASE("UTF-8 with and without a mark, and bytes of Windows-1252, are UTF-8") {
  CHECK(decode("\xEF\xBB\xBFt,x\n").text == "t,x\n");
  CHECK(decode("t,\xC2\xB5\n").encoding.empty());
  CHECK(decode("t,\xB5m,\x80\n").text == "t,\xC2\xB5m,\xE2\x82\xAC\n");
  CHECK(decode("t,\xB5m\n").encoding == "Windows-1252");
}

TEST_CASE("UTF-32 and UTF-16 that is cut off are refused with the name of the file") {
  using namespace std::string_literals;
  const Scratch scratch;
  CHECK_THROWS_WITH(read_record(scratch.file("a.csv", "\xFF\xFE\0\0t\0\0\0"s)),
                    Catch::EndsWith("a.csv: the file is in UTF-32; save it in UTF-8"));
  CHECK_THROWS_WITH(read_record(scratch.file("a.csv", "\xFF\xFEt\0,"s)),
                    Catch::EndsWith("a.csv: the file is cut off within a character of UTF-16"));
}

TEST_CASE("a table in UTF-16 is read with its units, as a spreadsheet saves Unicode text") {
  const Scratch scratch;
  const table::RecordTable table =
      read_record(scratch.file("a.csv", utf16(u"t [s]\tx [\u00B5m]\r\n0\t0,5\r\n0,5\t2\r\n", false)));
  CHECK(table.find("x")->unit == "\xC2\xB5m");
  CHECK(table.find("t")->values == std::vector<double>{0.0, 0.5});
  CHECK(table.notes ==
        std::vector<std::string>{"tabs between columns", "decimal comma", "UTF-16 (little endian)"});
}

}  // namespace stepwire::csv
