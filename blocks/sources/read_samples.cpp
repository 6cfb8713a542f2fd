#include "blocks/sources/read_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "blocks/records/preparation.hpp"
#include "blocks/sources/file_record.hpp"
#include "engine/base/data_file/reading_log.hpp"
#include "engine/base/data_file/recent.hpp"
#include "engine/base/data_file/table_cache.hpp"
#include "engine/base/io/inside.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/unit/meaning.hpp"
#include "engine/base/yaml/near_file.hpp"
#include "engine/model/block/configure.hpp"

namespace stepwire {

namespace {

std::shared_ptr<const table::RecordTable> read_file(const FromFile& asked, const Configure& is) {
  std::error_code none;
  io::require_inside(asked.file.string());
  if (!std::filesystem::exists(asked.file.view(), none))
    is.refuse<&FromFile::file>(
        ("there is no file " + asked.file.string() + yaml::near_file(asked.file.string())).text());
  if (!std::filesystem::is_regular_file(asked.file.view(), none))
    is.refuse<&FromFile::file>(fmt::format("{} is no file that holds a table", asked.file.string()));
  try {
    const auto decimal = static_cast<data_file::Decimal>(asked.decimal);
    return data_file::TableCache::of_process().read(asked.file.string(), decimal);
  } catch (const table::TableError& error) {
    is.refuse<&FromFile::file>(error.what());
  }
}

/// Returns the output's unit, if all columns have the same one; a vector with several units has none.
std::optional<std::string> unit_of(const Record& record) {
  const auto& dimension = record.columns.front().dimension;
  for (const RecordColumn& column : record.columns)
    if (!column.dimension || column.dimension != dimension) return std::nullopt;
  return unit::meaning_name(*dimension);
}

Samples samples_of(const Record& record) {
  std::vector<double> all;
  for (std::size_t row = 0; row < record.time.size(); ++row)
    for (const RecordColumn& column : record.columns) all.push_back(column.values[row]);
  return {Numbers(record.time),
          Matrix(static_cast<Index>(record.columns.size()), record.rows(), Numbers(all)), record.interval()};
}

/// Refuses unevenly spaced rows, since a Fourier transform requires even ones.
void require_even(const FromFile& asked, const Configure& is, const Record& record) {
  if (const auto row = first_uneven(record.time))
    is.refuse<&FromFile::interpolation>(
        fmt::format("band_limited needs evenly spaced rows, but in {} the row at {} s does not fit the mean "
                    "interval of {} s; "
                    "use linear, or prepare: [{{resample: {:.6g} s}}]",
                    asked.file.string(), record.time[static_cast<std::size_t>(*row)] + record.origin,
                    record.interval(), record.interval()));
}

PlayedRecord played(const FromFile& asked, const Configure& is,
                    const std::shared_ptr<const table::RecordTable>& table) {
  FileRecord read = read_file_record(asked, is, *table);
  Record& record = read.record;
  prepare_record(record, asked.prepare_.value(), [&](const std::string& message, const Value& where) {
    is.refuse<&FromFile::prepare_>(message, where);
  });
  PlayedRecord result{table, samples_of(record), {}, unit_of(record), table->notes};
  result.origin = record.origin;
  if (result.samples.begin() <= read.gaps.begin + result.samples.slack()) result.late = read.gaps.late;
  if (!read.gaps.any.empty() && !asked.prepare_.value().list())
    result.uneven = fmt::format(
        "repeats a period that all rows of the file give, but {} has no value and its row is left out; say "
        "`missing: hold`, or resample by `prepare`",
        read.gaps.any);
  result.notes.insert(result.notes.end(), read.notes.begin(), read.notes.end());
  if (asked.interpolation == FromFile::Interpolation::band_limited) {
    require_even(asked, is, record);
    result.smooth = BandLimited::through(result.samples.value);
  }
  return result;
}

/// Unique text of a request: each piece is preceded by its length.
class Name {
 public:
  explicit Name(const FromFile& asked) {
    add(asked.file.string());
    add(asked.column);
    add(asked.unit);
    add(std::string(asked.time));
    for (const double number : {asked.sample_time, asked.from, asked.to}) add(number);
    add(asked.interpolation == FromFile::Interpolation::band_limited ? 1.0 : 0.0);
    for (const int word : {static_cast<int>(asked.decimal), static_cast<int>(asked.missing), int{asked.sort}})
      add(static_cast<double>(word));
    add(asked.prepare_.value());
  }

  const std::string& text() const { return text_; }

 private:
  void add(const std::string& piece) { text_ += fmt::format("{}:{}", piece.size(), piece); }
  void add(const std::vector<std::string>& pieces) {
    text_ += fmt::format("[{}]", pieces.size());
    for (const std::string& piece : pieces) add(piece);
  }
  void add(double number) { text_ += fmt::format("{} ", number); }
  void add(const Eigen::VectorXd& numbers) { add(Eigen::MatrixXd(numbers)); }
  void add(const Eigen::MatrixXd& numbers) {
    text_ += fmt::format("[{} {}]", numbers.rows(), numbers.cols());
    for (const double number : numbers.reshaped()) add(number);
  }
  void add(const Value::List& list) {
    text_ += fmt::format("[{}]", list.size());
    for (const Value& item : list) add(item);
  }
  void add(const Value::Map& map) {
    text_ += fmt::format("{{{}}}", map.size());
    for (const ValueEntry& entry : map) {
      add(entry.key);
      add(entry.value);
    }
  }
  void add(const Value& tree) {
    text_ += static_cast<char>('a' + tree.content.index());
    std::visit([this](const auto& content) { add(content); }, tree.content);
  }

  std::string text_;
};

data_file::Recent<PlayedRecord>& records_of_process() {
  static data_file::Recent<PlayedRecord> records(8'000'000);
  return records;
}

}  // namespace

std::shared_ptr<const PlayedRecord> read_samples(const FromFile& asked, Configure& is) {
  const std::shared_ptr<const table::RecordTable> table = read_file(asked, is);
  const std::string name = Name(asked).text();
  auto record =
      records_of_process().find(name, [&](const PlayedRecord& known) { return known.table.lock() == table; });
  if (!record) {
    record = std::make_shared<const PlayedRecord>(played(asked, is, table));
    const Index numbers = record->samples.time.size() + record->samples.value.elements().size() +
                          record->smooth.fine.elements().size();
    records_of_process().keep(name, record, static_cast<std::size_t>(numbers));
  }
  data_file::ReadingLog::add(asked.file.string(), record->notes);
  if (record->unit) is.unit("'u", *record->unit);
  return record;
}

}  // namespace stepwire
