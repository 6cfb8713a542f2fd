#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire::mcap {

/// Columns from the JSON messages of one channel.
class ChannelRows {
 public:
  ChannelRows(std::string topic, const std::string& schema);

  const std::string& topic() const { return topic_; }
  std::size_t rows() const { return times_.size(); }
  std::size_t columns() const { return columns_.size() + 1; }
  /// Adds what a message says, logged at `time` [ns]. Throws TableError where it is no JSON.
  void add(std::string_view message, std::uint64_t time);
  /// Puts the columns into the table, the prefix before their names; times count from `begin` [ns].
  void give(table::RecordTable& table, const std::string& prefix, std::uint64_t begin);

 private:
  void add(const std::string& name, const json::Json& value);
  void add_units(const std::string& name, const json::Json& schema);
  std::vector<double>& column(const std::string& name);

  std::string topic_;
  std::vector<std::uint64_t> times_;
  std::vector<table::Column> columns_;
  std::map<std::string, std::size_t> places_;
  std::map<std::string, std::string> units_;
  std::map<std::string, std::string> problems_;
};

}  // namespace stepwire::mcap
