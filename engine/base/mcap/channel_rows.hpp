#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire::mcap {

/// Units by column name.
using Units = std::map<std::string, std::string>;
/// Returns the units in a JSON schema, from its words `unit`; an empty map for other texts.
Units units_of(std::string_view schema);

/// Collects columns from the JSON messages of one channel.
class ChannelRows {
 public:
  static constexpr std::size_t max_columns = 20'000;

  /// `units`: those of its schema; nullptr without a schema.
  ChannelRows(std::string topic, std::shared_ptr<const Units> units);

  const std::string& topic() const { return topic_; }
  std::size_t rows() const { return times_.size(); }
  std::size_t columns() const { return columns_.size() + 1; }
  /// Returns how many numbers its columns hold once they have equal length.
  std::size_t numbers() const { return columns() * rows(); }
  /// Adds the numbers of a message, logged at `time` [ns]. Throws TableError for invalid JSON and for more
  /// than max_columns columns.
  void add(std::string_view message, std::uint64_t time);
  /// Moves the columns into a table, with a prefix before their names; times are relative to `begin` [ns].
  void give(table::RecordTable& table, const std::string& prefix, std::uint64_t begin);

 private:
  void add(const std::string& name, const json::Json& value);
  std::vector<double>& column(const std::string& name);

  std::string topic_;
  std::vector<std::uint64_t> times_;
  std::vector<table::Column> columns_;
  std::map<std::string, std::size_t> places_;
  std::shared_ptr<const Units> units_;
  std::map<std::string, std::string> problems_;
};

}  // namespace stepwire::mcap
