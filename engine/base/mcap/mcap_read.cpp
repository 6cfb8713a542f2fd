#include "engine/base/mcap/mcap_read.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>

#include "engine/base/mcap/bytes.hpp"
#include "engine/base/mcap/channel_rows.hpp"

namespace stepwire::mcap {

namespace {

/// Reader of the records of one file.
class Reading {
 public:
  explicit Reading(std::size_t file_size) : max_numbers_(table::max_unpacked(file_size) / sizeof(double)) {}

  /// Reads the records of a file up to the end of its data, or those of a chunk.
  void read(std::string_view bytes, bool in_chunk) {
    Cursor records(bytes);
    while (!records.empty()) {
      const auto kind = static_cast<Kind>(records.number<std::uint8_t>());
      Cursor content(records.take(records.number<std::uint64_t>()));
      if (kind == Kind::data_end && !in_chunk) return;
      take(kind, content, in_chunk);
    }
    if (!in_chunk) throw table::TableError("the file is cut off");
  }

  table::RecordTable done() {
    table::RecordTable table;
    const bool several = std::ranges::count_if(channels_, [](const auto& one) { return one.second.rows() > 0; }) > 1;
    for (auto& [id, channel] : channels_)
      if (channel.rows() > 0) channel.give(table, several ? channel.topic() + "/" : "", begin_);
    if (table.columns.empty()) throw table::TableError("there are no JSON messages in the file");
    return table;
  }

 private:
  void take(Kind kind, Cursor& content, bool in_chunk) {
    if (kind == Kind::schema) take_schema(content);
    if (kind == Kind::channel) take_channel(content);
    if (kind == Kind::message) take_message(content);
    if (kind == Kind::chunk && !in_chunk) take_chunk(content);
  }

  void take_schema(Cursor& content) {
    const auto id = content.number<std::uint16_t>();
    content.text();  // name of the schema
    if (content.text() == "jsonschema")
      schemas_[id] = std::make_shared<const Units>(units_of(content.text()));
  }

  void take_channel(Cursor& content) {
    const auto id = content.number<std::uint16_t>(), schema = content.number<std::uint16_t>();
    const std::string topic(content.text());
    if (content.text() == "json") channels_.try_emplace(id, topic, schemas_[schema]);
  }

  void take_message(Cursor& content) {
    const auto channel = channels_.find(content.number<std::uint16_t>());
    content.number<std::uint32_t>();  // sequence number
    const auto time = content.number<std::uint64_t>();
    content.number<std::uint64_t>();  // publish time
    begin_ = std::min(begin_, time);
    if (channel == channels_.end()) return;
    ChannelRows& rows = channel->second;
    numbers_ -= rows.numbers();
    rows.add(content.rest(), time);
    numbers_ += rows.numbers();
    if (numbers_ > max_numbers_)
      throw table::TableError(fmt::format(
          "with {} columns of {} rows in '{}' it has more numbers than a file of this size may have",
          rows.columns(), rows.rows(), rows.topic()));
  }

  void take_chunk(Cursor& content) {
    content.take(2 * sizeof(std::uint64_t) + sizeof(std::uint64_t));  // start, end and uncompressed size
    const auto checksum = content.number<std::uint32_t>();
    if (const std::string_view packed = content.text(); !packed.empty())
      throw table::TableError(fmt::format("its messages are packed by '{}'; only those that are not are read", packed));
    const std::string_view records = content.take(content.number<std::uint64_t>());
    const auto actual = ::crc32_z(0, reinterpret_cast<const Bytef*>(records.data()), records.size());
    if (checksum != 0 && checksum != actual)
      throw table::TableError("the file is damaged: a checksum is not that of its messages");
    read(records, true);
  }

  std::size_t max_numbers_, numbers_ = 0;  ///< of all channels
  std::uint64_t begin_ = std::numeric_limits<std::uint64_t>::max();
  std::map<std::uint16_t, std::shared_ptr<const Units>> schemas_;
  std::map<std::uint16_t, ChannelRows> channels_;
};

}  // namespace

table::RecordTable read_mcap(const std::string& path) {
  const std::string file = io::read_file(path);
  try {
    if (!file.starts_with(magic)) throw table::TableError("this is no MCAP file");
    Reading reading(file.size());
    reading.read(std::string_view(file).substr(magic.size()), false);
    table::RecordTable table = reading.done();
    for (auto& [column, problem] : table.problems) problem = fmt::format("{}: {}", path, problem);
    return table;
  } catch (const table::TableError& error) {
    throw table::TableError(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace stepwire::mcap
