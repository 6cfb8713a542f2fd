#include "engine/base/csv/cell.hpp"

#include <catch2/catch.hpp>

#include "engine/base/table/csv_cell.hpp"

namespace stepwire::csv {

namespace {

/// The number of a cell; nan for none.
double number(const std::string& text, Decimal decimal) {
  const auto cell = cell_number(text, decimal);
  return cell ? table::csv_number(cell->text).value() : NAN;
}

bool is_number(const std::string& text, Decimal decimal) {
  return cell_number(text, decimal).has_value();
}

}  // namespace

TEST_CASE("a cell proves its decimal mark, or leaves both open where three digits follow one mark") {
  CHECK(shape_of("0,2") == Shape::comma);
  CHECK(shape_of("12,5") == Shape::comma);
  CHECK(shape_of("0,125") == Shape::comma);  // a thousand is not written with a 0 in front
  CHECK(shape_of("1234,567") == Shape::comma);
  CHECK(shape_of("-,5") == Shape::comma);
  CHECK(shape_of("1,234E+02") == Shape::comma);
  CHECK(shape_of("0.2") == Shape::point);
  CHECK(shape_of("1.") == Shape::point);
  CHECK(shape_of("1.234,5") == Shape::grouped_comma);
  CHECK(shape_of("1.234.567") == Shape::grouped_comma);
  CHECK(shape_of("1,234.5") == Shape::grouped_point);
  CHECK(shape_of("-1,234,567") == Shape::grouped_point);
  CHECK(shape_of("1,234") == Shape::either_comma);
  CHECK(shape_of("123.456") == Shape::either_point);
  CHECK(shape_of("1234") == Shape::plain);
}

TEST_CASE("texts, dates and broken groups are no numbers") {
  for (const char* text : {"", "x", "1,2,3", "1.2.3", "12,34,567", "1,2345.6", "27.11.2026", "192.168.0.1",
                           "1 234", "2 mm", "0x10", "--1", "1e", ".", ",", "1.234,5,6"}) {
    INFO(text);
    CHECK(shape_of(text) == Shape::other);
    CHECK_FALSE(is_number(text, Decimal::comma));
    CHECK_FALSE(is_number(text, Decimal::point));
  }
}

TEST_CASE("a mark is decimal, parts thousands, or makes a cell no number, as the file's mark says") {
  CHECK(number("0,25", Decimal::comma) == 0.25);
  CHECK(number("1.234,5", Decimal::comma) == 1234.5);
  CHECK(number("1.234", Decimal::comma) == 1234.0);
  CHECK(number("1,234", Decimal::comma) == 1.234);
  CHECK(number("1,234.5", Decimal::point) == 1234.5);
  CHECK(number("+1,234", Decimal::point) == 1234.0);
  CHECK(number("1.234", Decimal::point) == 1.234);
  CHECK_FALSE(is_number("0.25", Decimal::comma));
  CHECK_FALSE(is_number("0,25", Decimal::point));
  CHECK_FALSE(is_number("1.234,5", Decimal::point));
}

TEST_CASE("apostrophes and fixed blanks part thousands, whatever the decimal mark") {
  CHECK(number("12'345.5", Decimal::point) == 12345.5);
  CHECK(number("1\xC2\xA0"
               "234,5",
               Decimal::comma) == 1234.5);
  CHECK(number("1\xE2\x80\xAF"
               "234\xE2\x80\xAF"
               "567",
               Decimal::comma) == 1234567.0);
  CHECK_FALSE(is_number("12'34", Decimal::point));
}

TEST_CASE("exponents of Fortran are read as those of C") {
  CHECK(number("1.0D+03", Decimal::point) == 1000.0);
  CHECK(number("-2.5d-01", Decimal::point) == -0.25);
  CHECK(number("0.1234E+05", Decimal::point) == 12340.0);
  CHECK(number("1.5-104", Decimal::point) == 1.5e-104);  // three digits leave no room for the letter
  CHECK(number("1.5+103", Decimal::point) == 1.5e103);
  CHECK(number("2D0", Decimal::point) == 2.0);
  CHECK(number("1,0E+03", Decimal::comma) == 1000.0);
}

TEST_CASE("the minus sign of typography is a minus") {
  CHECK(number("\xE2\x88\x92"
               "2.5",
               Decimal::point) == -2.5);
  CHECK(number("1,5E"
               "\xE2\x88\x92"
               "03",
               Decimal::comma) == 0.0015);
}

TEST_CASE("an exponent of two digits without its letter is known, and no number") {
  CHECK(with_exponent_letter("1.0+3") == "1.0e+3");
  CHECK(with_exponent_letter("-2,5-01") == "-2,5e-01");
  CHECK_FALSE(is_number("1.0+3", Decimal::point));
  for (const char* text : {"1.5-104", "1+3", "2026-01-31", "31.01.2026", "1.0e+3", "-1.5", "a.0+3", ""})
    CHECK(with_exponent_letter(text) == "");
}

TEST_CASE("the words of other programs for a missing value are known") {
  for (const char* word : {"", "NaN", "nan", "NA", "N/A", "#N/A", "null", "NULL", "None", "-nan", "<NA>"}) {
    INFO(word);
    CHECK(is_missing(word));
  }
  for (const char* word : {"0", "inf", "off", "-", "nano"}) CHECK_FALSE(is_missing(word));
}

}  // namespace stepwire::csv
