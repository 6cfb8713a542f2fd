#include "engine/analyse/study/repetition.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <sstream>

#include "engine/base/hash/hash.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::study {

namespace {

/// Returns a line with its hash appended.
std::string checked(const std::string& line) {
  return line + "," + hash::hash_of(line);
}

/// Returns the numbers of such a line; std::nullopt if the hash does not match.
std::optional<std::vector<double>> numbers_of(const std::string& text) {
  const std::string line = text.substr(0, text.rfind(','));
  if (checked(line) != text) return std::nullopt;
  std::vector<double> numbers;
  const char* const end = line.data() + line.size();
  for (const char* at = line.data(); at < end; ++at) {
    const auto read = std::from_chars(at, end, numbers.emplace_back());
    if (read.ec != std::errc() || (read.ptr != end && *read.ptr != ',')) return std::nullopt;
    at = read.ptr;
  }
  return numbers;
}

/// Returns the complete lines of a file; a last line without a newline is left out.
std::istringstream whole_lines(const std::string& path) {
  const std::string text = io::read_file(path);
  return std::istringstream(text.substr(0, text.rfind('\n') + 1));
}

}  // namespace

KeptRows read_kept_rows(const std::string& path) {
  std::istringstream lines = whole_lines(path);
  KeptRows kept;
  std::string line;
  std::getline(lines, kept.head);
  for (std::size_t number = 2; std::getline(lines, line); ++number) {
    const auto numbers = numbers_of(line);
    if (!numbers || numbers->size() < 2)
      throw table::TableError(fmt::format(
          "{}:{}: this experiment is not as it was written: its check does not fit its numbers; delete the "
          "line; it is performed again",
          path, number));
    const std::pair key{static_cast<std::uint64_t>((*numbers)[0]),
                        static_cast<std::size_t>((*numbers)[1]) - 1};
    kept.rows[key].assign(numbers->begin() + 2, numbers->end());
  }
  return kept;
}

std::string Repetition::head() const {
  table::Table table{{{"seed", "", {}}, {"point", "", {}}}};
  for (const OutcomeColumn& column : columns_) table.columns.push_back({column.name, column.unit, {}});
  table.columns.push_back({"check", "", {}});
  std::string text = table::csv_text(table);
  text.pop_back();
  return text;
}

void Repetition::read(const std::string& path) {
  KeptRows kept = read_kept_rows(path);
  if (kept.head.empty()) return;  // cut in its first line
  if (kept.head != head())
    throw table::TableError(
        fmt::format("{}:1: these are no experiments of this study, whose columns are {}", path, head()));
  for (auto& [key, values] : kept.rows) {
    values.resize(columns_.size());
    rows_[key] = std::move(values);
  }
}

std::string Repetition::csv() const {
  std::string text = head() + "\n", line;
  for (const auto& [key, values] : rows_) {
    line = fmt::format("{},{}", key.first, key.second + 1);
    for (const double value : values) table::append_csv_number(line += ",", value);
    text += checked(line) + "\n";
  }
  return text;
}

bool Repetition::has(std::uint64_t seed, std::size_t points) const {
  for (std::size_t point = 0; point < points; ++point)
    if (!rows_.contains({seed, point})) return false;
  return true;
}

void Repetition::add(const ExperimentOutcome& outcome, std::size_t point) {
  std::vector<double> values;
  for (const OutcomeColumn& column : columns_) values.push_back(value_of(outcome.values, column.name));
  rows_[{outcome.seed, point}] = std::move(values);
}

std::vector<ExperimentOutcome> Repetition::outcomes(std::size_t point) const {
  std::vector<ExperimentOutcome> all;
  for (const auto& [key, values] : rows_) {
    if (key.second != point) continue;
    all.push_back({key.first, {}});
    for (std::size_t i = 0; i < columns_.size(); ++i)
      all.back().values.push_back({columns_[i].name, values[i]});
  }
  return all;
}

}  // namespace stepwire::study
