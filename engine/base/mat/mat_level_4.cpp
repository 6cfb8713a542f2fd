#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

#include "engine/base/mat/mat_content.hpp"
#include "engine/base/mat/mat_unreadable.hpp"
#include "engine/base/table/table_file.hpp"

// Layout: "MAT-File Format", The MathWorks, appendix on level 4. The header is type, rows, columns, complex
// flag and length of the name; the name and the numbers follow. The digits of the type are byte order, 0,
// number type and kind of matrix.

namespace stepwire::mat {
namespace {

constexpr std::size_t header_size = 20, longest_name_4 = 1000;
constexpr std::uint32_t largest_type = 4052;

constexpr std::array<MatNumber, 6> kinds{MatNumber::float64, MatNumber::float32, MatNumber::int32,
                                         MatNumber::int16,   MatNumber::uint16,  MatNumber::uint8};

std::array<std::uint32_t, 5> words_of(std::string_view header, bool swap) {
  std::array<std::uint32_t, 5> words{};
  const std::vector<double> numbers = mat_numbers(header, MatNumber::uint32, swap);
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint32_t>(numbers[i]);
  return words;
}

class Level4 {
 public:
  explicit Level4(std::string_view file) : rest_(file) {}

  MatContent read() {
    while (!rest_.empty()) matrix();
    return std::move(content_);
  }

 private:
  std::string_view take(std::size_t count) {
    if (count > rest_.size()) throw table::TableError("the file is damaged or cut off");
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  [[noreturn]] static void refuse() { throw table::TableError("this is no MAT file, or it is damaged"); }

  void matrix() {
    const std::string_view header = take(header_size);
    const bool swap = words_of(header, false)[0] > largest_type;
    const auto [type, rows, columns, complex, name_length] = words_of(header, swap);
    const std::uint32_t order = type / 1000, kind = type / 10 % 10, form = type % 10;
    const bool big = (std::endian::native == std::endian::big) != swap;
    if (type > largest_type || type / 100 % 10 != 0 || kind >= kinds.size() || form > 2 ||
        order != (big ? 1u : 0u) || complex > 1 || name_length == 0 || name_length > longest_name_4)
      refuse();
    const std::string_view name = take(name_length);
    const std::size_t count = mat_count({rows, columns});
    const std::string_view numbers = take(count * (1 + complex) * mat_number_size(kinds[kind]));
    if (form == 1 || count == 0) return;  // texts are skipped
    const std::string text(name.substr(0, name.find('\0')));
    if (form == 2 || complex == 1)
      return content_.problems.push_back(
          {text, unreadable_text(text, form == 2 ? MatUnreadable::sparse : MatUnreadable::complex)});
    content_.variables.push_back({text, {rows, columns}, mat_numbers(numbers, kinds[kind], swap)});
  }

  std::string_view rest_;
  MatContent content_;
};

}  // namespace

MatContent read_mat_level_4(std::string_view file) {
  if (file.empty()) throw table::TableError("the file is empty");
  return Level4(file).read();
}

}  // namespace stepwire::mat
