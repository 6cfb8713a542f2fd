#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "engine/base/table/csv_cell.hpp"
#include "engine/base/table/csv_lines.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::table {
namespace {

/// Assigns the numbers 0, 1, ... to the words of one column.
struct CsvNumbering {
  std::vector<std::string>* texts = nullptr;  ///< nullptr for a column of numbers
  std::unordered_map<std::string, double> numbers{};

  double operator()(const std::string& text) {
    const auto [place, is_new] = numbers.try_emplace(text, static_cast<double>(texts->size()));
    if (is_new) texts->push_back(text);
    return place->second;
  }
};

/// Reader of CSV files with numbers, and words in the given columns. Files of other programs are read by
/// base/csv.
class Csv {
 public:
  Csv(const std::string& path, std::string_view text, ColumnWords& words)
      : path_(path), lines_(path, text.substr(text.starts_with("\xEF\xBB\xBF") ? 3 : 0)), words_(words) {
    lines_.separate_by(lines_.separator_of_line());
  }

  Table read() {
    header();
    for (; !lines_.only_blanks_left(); ++rows_) row();
    return std::move(table_);
  }

  Table read_header() {
    header();
    return std::move(table_);
  }

 private:
  void header() {
    if (lines_.only_blanks_left()) throw TableError(fmt::format("{}: the file is empty", path_));
    const std::vector<std::string> titles = lines_.fields();
    require_csv_names(titles, lines_);
    std::unordered_set<std::string> names;
    for (const std::string& title : titles) {
      table_.columns.push_back(csv_column(csv_word(title)));
      const std::string& name = table_.columns.back().name;
      if (name.empty()) lines_.fail(fmt::format("column {} has no name", table_.columns.size()));
      if (!names.insert(name).second) lines_.fail(fmt::format("two columns are named '{}'", csv_shown(name)));
      const auto words = words_.find(name);
      numberings_.push_back({words == words_.end() ? nullptr : &words->second});
    }
    lines_.skip_line_end();
  }

  void row() {
    const CsvLines::Place start = lines_.place();
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      if (i > 0) lines_.skip_separator();
      const bool last = i + 1 == table_.columns.size();
      const auto value = numberings_[i].texts ? std::nullopt : lines_.quick_number();
      if (!value || lines_.at_line_end() != last) {
        lines_.go_to(start);
        return row_slowly();
      }
      table_.columns[i].values.push_back(*value);
    }
    lines_.skip_line_end();
  }

  /// Reads a row with words, quoted numbers or a plus sign, and reports why a row is invalid.
  void row_slowly() {
    const std::vector<std::string> texts = lines_.fields();
    const std::size_t wanted = table_.columns.size(), count = texts.size();
    if (count != wanted)
      lines_.fail(fmt::format("{} value{} where the header names {}", count, count == 1 ? "" : "s", wanted));
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = numberings_[i].texts ? numberings_[i](csv_word(texts[i])) : csv_number(texts[i]);
      if (!value)
        lines_.fail(fmt::format("'{}' {} (column '{}')", csv_shown(texts[i]), csv_number_problem(texts[i]),
                                csv_shown(table_.columns[i].name)));
      table_.columns[i].values.resize(rows_);
      table_.columns[i].values.push_back(*value);
    }
    lines_.skip_line_end();
  }

  const std::string& path_;
  CsvLines lines_;
  std::size_t rows_ = 0;
  Table table_;
  ColumnWords& words_;
  std::vector<CsvNumbering> numberings_;  ///< one for each column
};

}  // namespace

void require_csv_names(const std::vector<std::string>& titles, const CsvLines& lines) {
  if (std::ranges::all_of(titles, [](const std::string& title) { return csv_number(title).has_value(); }))
    lines.fail("the first line holds numbers; it must name the columns");
}

Table read_csv(const std::string& path) {
  ColumnWords none;
  Table table = read_csv(path, none);
  if (table.rows() == 0) throw TableError(fmt::format("{}: there are no rows below the header", path));
  return table;
}

Table read_csv(const std::string& path, ColumnWords& words) {
  const std::string text = io::read_file(path);
  return Csv(path, text, words).read();
}

Table read_csv_header(const std::string& path) {
  const std::string text = io::read_file(path);
  ColumnWords none;
  return Csv(path, text, none).read_header();
}

}  // namespace stepwire::table
