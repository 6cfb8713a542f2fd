#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "engine/base/hdf5/matlab_file.hpp"
#include "engine/base/mat/mat_file.hpp"
#include "engine/base/mat/mat_names.hpp"
#include "engine/base/table/table_file.hpp"

// Writer of level 5. The library for HDF5 is not used here, because it drops the system's error for a full
// disk. Layout: "MAT-File Format", The MathWorks. Numbers have the byte order of the machine, which the
// header states.

namespace stepwire::mat {
namespace {

enum class Element : std::uint32_t { int8 = 1, uint16 = 4, int32 = 5, uint32 = 6, float64 = 9, matrix = 14 };
enum class Class : std::uint32_t { cell = 1, text = 4, float64 = 6 };

constexpr std::size_t longest_element = max_bytes_of_level_5;

template <class T>
std::string bytes(const T* values, std::size_t count) {
  std::string result(count * sizeof(T), '\0');
  if (count > 0) std::memcpy(result.data(), values, result.size());
  return result;
}

/// Encodes type, length and bytes, padded to a multiple of eight.
std::string element(Element type, const std::string& content) {
  if (content.size() > longest_element)
    throw table::TableError("a column is too long for a MAT file of level 5");
  const std::array<std::uint32_t, 2> tag{static_cast<std::uint32_t>(type),
                                         static_cast<std::uint32_t>(content.size())};
  return bytes(tag.data(), tag.size()) + content + std::string((8 - content.size() % 8) % 8, '\0');
}

std::string matrix(Class type, std::size_t rows, std::size_t columns, const std::string& name,
                   const std::string& content) {
  const std::array<std::uint32_t, 2> flags{static_cast<std::uint32_t>(type), 0};
  const std::array<std::int32_t, 2> size{static_cast<std::int32_t>(rows), static_cast<std::int32_t>(columns)};
  return element(Element::matrix, element(Element::uint32, bytes(flags.data(), 2)) +
                                      element(Element::int32, bytes(size.data(), 2)) +
                                      element(Element::int8, name) + content);
}

/// Converts text to UTF-16, the encoding of the format.
std::u16string utf16(std::string_view text) {
  std::u16string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i++]);
    const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
    std::uint32_t code = more == 0 ? first : first & (0x3Fu >> more);
    for (int k = 0; k < more && i < text.size(); ++k)
      code = code << 6 | (static_cast<unsigned char>(text[i++]) & 0x3Fu);
    if (code < 0x10000) {
      result += static_cast<char16_t>(code);
    } else {
      result += static_cast<char16_t>(0xD7C0 + (code >> 10));
      result += static_cast<char16_t>(0xDC00 + (code & 0x3FF));
    }
  }
  return result;
}

std::string text_matrix(const std::string& text) {
  const std::u16string units = utf16(text);
  return matrix(Class::text, units.empty() ? 0 : 1, units.size(), "",
                element(Element::uint16, bytes(units.data(), units.size())));
}

std::string text_cells(const std::string& name, const std::vector<table::Column>& columns,
                       std::string table::Column::*text) {
  std::string cells;
  for (const table::Column& column : columns) cells += text_matrix(column.*text);
  return matrix(Class::cell, columns.size(), 1, name, cells);
}

/// Returns the header: 116 bytes of text, 8 zero bytes, version and byte order. It has no date, so that the
/// same table gives the same bytes.
std::string header_text(const char* level, std::uint16_t version) {
  std::string text = std::string("MATLAB ") + level + " MAT-file, created by stepwire";
  text.resize(116, ' ');
  const std::array<std::uint16_t, 2> end{version, 0x4D49};
  return text + std::string(8, '\0') + bytes(end.data(), 2);
}

std::string header_of_level_5() {
  return header_text("5.0", 0x0100);
}

std::vector<std::string> names_of(const table::Table& table) {
  std::vector<std::string> names;
  for (const table::Column& column : table.columns) names.push_back(column.name);
  return names;
}

std::vector<std::u16string> texts_of(const table::Table& table, std::string table::Column::*text) {
  std::vector<std::u16string> texts;
  for (const table::Column& column : table.columns) texts.push_back(utf16(column.*text));
  return texts;
}

/// True where a column exceeds the 32-bit sizes of level 5.
bool is_too_long(const table::Table& table, std::size_t max_bytes) {
  constexpr std::size_t around = 128;  // tags, size and name
  return std::ranges::any_of(table.columns, [&](const table::Column& column) {
    return column.values.size() * sizeof(double) + around > max_bytes;
  });
}

void write_level_7(const std::string& path, const table::Table& table) {
  hdf5::MatlabFile file(path, header_text("7.3", 0x0200));
  const std::vector<std::string> names = matlab_names(names_of(table));
  for (std::size_t i = 0; i < names.size(); ++i)
    file.add(names[i], table.columns[i].values.size(), 1, table.columns[i].values);
  file.add("names", texts_of(table, &table::Column::name));
  file.add("units", texts_of(table, &table::Column::unit));
  file.finish();
}

}  // namespace

void write_mat(const std::string& path, const std::vector<NamedMatrix>& matrices,
               const std::vector<NamedTextList>& texts) {
  std::string content = header_of_level_5();
  for (const NamedMatrix& one : matrices)
    content += matrix(Class::float64, one.rows, one.columns, one.name,
                      element(Element::float64, bytes(one.values.data(), one.values.size())));
  for (const NamedTextList& list : texts) {
    std::string cells;
    for (const std::string& text : list.texts) cells += text_matrix(text);
    content += matrix(Class::cell, list.texts.size(), 1, list.name, cells);
  }
  io::write_file(path, content);
}

void write_mat(const std::string& path, const table::Table& table, std::size_t max_bytes) {
  if (is_too_long(table, max_bytes)) return write_level_7(path, table);
  std::string content = header_of_level_5();
  const std::vector<std::string> names = matlab_names(names_of(table));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<double>& values = table.columns[i].values;
    content += matrix(Class::float64, values.size(), 1, names[i],
                      element(Element::float64, bytes(values.data(), values.size())));
  }
  content += text_cells("names", table.columns, &table::Column::name);
  content += text_cells("units", table.columns, &table::Column::unit);
  io::write_file(path, content);
}

}  // namespace stepwire::mat
