#include "engine/base/mcap/mcap_writer.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

#include "engine/base/io/atomic_file_writer.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/mcap/bytes.hpp"

namespace stepwire::mcap {
namespace {

/// Layout of a row of a run as a JSON object. The dotted parts of a name become nested objects, so that
/// viewers can unfold them. Where `a` itself is a column, `a.b` is a plain member of that name. The run must
/// outlive the layout.
class RowShape {
 public:
  explicit RowShape(const table::RunView& run);

  /// Returns the JSON schema of a row, with units.
  std::string schema(const std::string& title) const;
  void append_row(std::string& text, std::size_t row) const;

 private:
  /// A member: a column, or an object with further members.
  struct Member {
    std::string key;
    const table::SeriesView* series = nullptr;
    std::vector<Member> members{};
  };

  bool is_column(const std::string& name) const;
  void add(const table::SeriesView& series);
  static json::Json schema_of(const Member& member);
  void spell(const Member& member, std::string& text);

  const table::RunView& run_;
  Member root_;
  /// Precomputed text followed by the number of its column; a row is all pieces and `end_`.
  struct Piece {
    std::string text;
    const table::SeriesView* series;
  };
  std::vector<Piece> pieces_;
  std::string end_;
};

using json::Json;

RowShape::RowShape(const table::RunView& run) : run_(run) {
  for (const table::SeriesView& series : run.series) add(series);
  std::string text;
  spell(root_, text);
  end_ = std::move(text);
}

bool RowShape::is_column(const std::string& name) const {
  return std::ranges::find(run_.series, name, &table::SeriesView::name) != run_.series.end();
}

void RowShape::add(const table::SeriesView& series) {
  Member* place = &root_;
  std::size_t first = 0;
  for (std::size_t point = series.name.find('.');
       point != std::string::npos && !is_column(series.name.substr(0, point));
       point = series.name.find('.', first)) {
    const std::string key = series.name.substr(first, point - first);
    const auto known = std::ranges::find(place->members, key, &Member::key);
    place = known != place->members.end() ? &*known : &place->members.emplace_back(Member{key});
    first = point + 1;
  }
  place->members.push_back({series.name.substr(first), &series});
}

Json RowShape::schema_of(const Member& member) {
  if (member.series) {
    Json schema = Json::object().set("type", member.series->words.empty() ? "number" : "string");
    if (!member.series->unit.empty()) schema.set("unit", member.series->unit);
    return schema;
  }
  Json members = Json::object();
  for (const Member& one : member.members) members.set(one.key, schema_of(one));
  return Json::object().set("type", "object").set("properties", std::move(members));
}

std::string RowShape::schema(const std::string& title) const {
  return schema_of(root_).set("title", title).text(-1);
}

void RowShape::spell(const Member& member, std::string& text) {
  if (member.series) return pieces_.push_back({std::exchange(text, ""), member.series});
  const char* before = "{";
  for (const Member& one : member.members) {
    text += before + Json(one.key).text(-1) + ":";
    spell(one, text);
    before = ",";
  }
  text += member.members.empty() ? "{}" : "}";
}

void RowShape::append_row(std::string& text, std::size_t row) const {
  for (const Piece& piece : pieces_) {
    text += piece.text;
    const double number = piece.series->values[row];
    const auto& words = piece.series->words;
    if (!std::isfinite(number))
      text += "null";
    else if (number >= 0.0 && number < static_cast<double>(words.size()))
      text += Json(words[static_cast<std::size_t>(number)]).text(-1);
    else
      fmt::format_to(std::back_inserter(text), "{}", number);
  }
  text += end_;
}

constexpr std::size_t bytes_of_chunk = 1 << 20;
constexpr std::size_t max_runs = std::numeric_limits<std::uint16_t>::max();

std::uint32_t checksum(std::uint32_t before, std::string_view bytes) {
  return static_cast<std::uint32_t>(
      ::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// Converts a time to nanoseconds; 0 for NaN and for times before 0.
std::uint64_t nanoseconds(double seconds) {
  return seconds > 0.0 && seconds < 9e9 ? static_cast<std::uint64_t>(std::llround(seconds * 1e9)) : 0;
}

struct Span {
  std::uint64_t first = std::numeric_limits<std::uint64_t>::max(), last = 0;

  void add(std::uint64_t time) {
    first = std::min(first, time);
    last = std::max(last, time);
  }
  void put(std::string& bytes) const {
    append(bytes, std::min(first, last));
    append(bytes, last);
  }
};

/// Messages that are written together, and the message index of each channel.
struct Chunk {
  std::string records;
  Span span;
  std::map<std::uint16_t, std::string> index;
};

}  // namespace

struct McapWriter::File {
  io::AtomicFileWriter writer;
  std::string title, path;
  std::uint64_t written = 0;   ///< [bytes]
  std::uint32_t data_crc = 0;  ///< CRC of these bytes
  std::string schemas, channels, chunk_indexes, last_schema;
  Chunk chunk;
  Span span;
  std::map<std::uint16_t, std::uint64_t> messages;  ///< number of messages by channel
  std::uint32_t chunks = 0;
  std::uint16_t schema_count = 0;

  File(const std::string& of, const std::string& title_of) : writer(of), title(title_of), path(of) {
    std::string header;
    append_sized(header, "");
    append_sized(header, "stepwire");
    put(magic);
    put(record(Kind::header, header));
  }

  void put(std::string_view bytes) {
    writer.append(bytes);
    written += bytes.size();
    data_crc = checksum(data_crc, bytes);
  }

  void put_schema(const std::string& text) {
    if (text == last_schema) return;
    last_schema = text;
    std::string content;
    append(content, ++schema_count);
    append_sized(content, title);
    append_sized(content, "jsonschema");
    append_sized(content, text);
    const std::string bytes = record(Kind::schema, content);
    schemas += bytes;
    chunk.records += bytes;
  }

  std::uint16_t put_channel(const table::RunView& run) {
    if (messages.size() == max_runs)
      throw io::EnvironmentError(
          fmt::format("{}: an MCAP file has at most {} channels, one for each run", path, max_runs));
    const auto channel = static_cast<std::uint16_t>(messages.size());
    messages[channel] = 0;
    std::string content, metadata;
    append(content, channel);
    append(content, schema_count);
    append_sized(content, run.name.empty() ? "signals" : run.name);
    append_sized(content, "json");
    for (const table::SweptValue& value : run.swept) {
      append_sized(metadata, value.name);
      append_sized(metadata, !value.word.empty()  ? value.word
                             : value.unit.empty() ? fmt::format("{}", value.number)
                                                  : fmt::format("{} {}", value.number, value.unit));
    }
    append_sized(content, metadata);
    const std::string bytes = record(Kind::channel, content);
    channels += bytes;
    chunk.records += bytes;
    return channel;
  }

  void put_message(std::uint16_t channel, std::uint32_t sequence, std::uint64_t time, std::string_view text) {
    append(chunk.index[channel], time);
    append(chunk.index[channel], static_cast<std::uint64_t>(chunk.records.size()));
    chunk.span.add(time);
    span.add(time);
    ++messages[channel];
    std::string content;
    append(content, channel);
    append(content, sequence);
    append(content, time);
    append(content, time);
    chunk.records += record(Kind::message, content.append(text));
    if (chunk.records.size() >= bytes_of_chunk) put_chunk();
  }

  void put_chunk() {
    if (chunk.records.empty()) return;
    const std::uint64_t begin = written;
    std::string content;
    chunk.span.put(content);
    append(content, static_cast<std::uint64_t>(chunk.records.size()));
    append(content, checksum(0, chunk.records));
    append_sized(content, "");
    append(content, static_cast<std::uint64_t>(chunk.records.size()));
    put(record(Kind::chunk, content + chunk.records));
    put_indexes(begin, written - begin);
    ++chunks;
    chunk = {};
  }

  void put_indexes(std::uint64_t begin, std::uint64_t length) {
    const std::uint64_t indexes = written;
    std::string places;
    for (const auto& [channel, entries] : chunk.index) {
      append(places, channel);
      append(places, written);
      std::string content;
      append(content, channel);
      append_sized(content, entries);
      put(record(Kind::message_index, content));
    }
    std::string content;
    chunk.span.put(content);
    append(content, begin);
    append(content, length);
    append_sized(content, places);
    append(content, written - indexes);
    append_sized(content, "");
    append(content, static_cast<std::uint64_t>(chunk.records.size()));
    append(content, static_cast<std::uint64_t>(chunk.records.size()));
    chunk_indexes += record(Kind::chunk_index, content);
  }

  std::string statistics() const {
    std::string content, counts;
    std::uint64_t all = 0;
    for (const auto& [channel, count] : messages) {
      all += count;
      append(counts, channel);
      append(counts, count);
    }
    append(content, all);
    append(content, schema_count);
    append(content, static_cast<std::uint32_t>(messages.size()));
    append(content, std::uint32_t{0});  // number of attachments
    append(content, std::uint32_t{0});  // number of metadata records
    append(content, chunks);
    span.put(content);
    append_sized(content, counts);
    return record(Kind::statistics, content);
  }

  void put_data_end() {
    std::string content;
    append(content, data_crc);
    put(record(Kind::data_end, content));
  }

  /// Writes the summary section: all records but messages again, and the offset of each kind.
  void put_summary() {
    const std::uint64_t begin = written;
    std::string summary, offsets;
    for (const auto& [kind, records] :
         {std::pair(Kind::schema, schemas), std::pair(Kind::channel, channels),
          std::pair(Kind::statistics, statistics()), std::pair(Kind::chunk_index, chunk_indexes)}) {
      if (records.empty()) continue;
      std::string content(1, static_cast<char>(kind));
      append(content, begin + summary.size());
      append(content, static_cast<std::uint64_t>(records.size()));
      offsets += record(Kind::summary_offset, content);
      summary += records;
    }
    put_footer(summary + offsets, begin, begin + summary.size());
  }

  void put_footer(std::string summary, std::uint64_t begin, std::uint64_t offsets) {
    std::string content;
    append(content, begin);
    append(content, offsets);
    append(content, std::uint32_t{0});
    summary += record(Kind::footer, content);
    summary.resize(summary.size() - sizeof(std::uint32_t));  // the checksum covers all bytes before it
    append(summary, checksum(0, summary));
    put(summary);
    put(magic);
  }
};

McapWriter::McapWriter(const std::string& path, const std::string& title)
    : file_(std::make_unique<File>(path, title)) {}

McapWriter::~McapWriter() = default;

void McapWriter::add(const table::RunView& run) {
  const RowShape shape(run);
  file_->put_schema(shape.schema(file_->title));
  const std::uint16_t channel = file_->put_channel(run);
  const std::span<const double> times =
      run.series.empty() ? std::span<const double>() : run.series.front().values;
  std::string text;
  for (std::size_t row = 0; row < times.size(); ++row) {
    text.clear();
    shape.append_row(text, row);
    file_->put_message(channel, static_cast<std::uint32_t>(row), nanoseconds(times[row]), text);
  }
}

void McapWriter::finish() {
  file_->put_chunk();
  file_->put_data_end();
  file_->put_summary();
  file_->writer.finish();
}

}  // namespace stepwire::mcap
