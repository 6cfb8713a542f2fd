#include "engine/simulate/journal/point_bytes.hpp"

#include <bit>
#include <cstring>
#include <type_traits>

#include "engine/simulate/record/recorder.hpp"

namespace stepwire::journal {

namespace {

static_assert(std::endian::native == std::endian::little);

class Writer {
 public:
  template <class Number>
  void put(Number number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }
  void put(const std::string& text) {
    put<std::uint64_t>(text.size());
    bytes_ += text;
  }
  void put(const std::vector<double>& numbers) {
    bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads what a Writer has written; of too few bytes it gives zeros, and `whole()` is false from then on.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  template <class Number>
  void get(Number& number) {
    copy(&number, sizeof(number));
  }
  void get(std::string& text) {
    std::uint64_t size = 0;
    get(size);
    if (size > rest_.size()) return fail();
    text = rest_.substr(0, size);
    rest_.remove_prefix(size);
  }
  void get(std::vector<double>& numbers, std::size_t count) {
    if (count > rest_.size() / sizeof(double)) return fail();
    numbers.resize(count);
    copy(numbers.data(), count * sizeof(double));
  }
  /// Reads a list whose elements take at least one byte each.
  template <class Element, class Get>
  void get_list(std::vector<Element>& list, const Get& get_one) {
    std::uint64_t size = 0;
    get(size);
    if (size > rest_.size()) return fail();
    for (std::uint64_t i = 0; i < size && whole_; ++i) get_one(list.emplace_back());
  }
  bool whole() const { return whole_; }
  bool at_end() const { return rest_.empty(); }

 private:
  void fail() {
    whole_ = false;
    rest_ = {};
  }
  void copy(void* to, std::size_t size) {
    if (size > rest_.size()) return fail();
    if (size == 0) return;
    std::memcpy(to, rest_.data(), size);
    rest_.remove_prefix(size);
  }

  std::string_view rest_;
  bool whole_ = true;
};

/// Each part is named once: the same lines write and read it.
template <class Stream, class Part>
void each(Stream& stream, Part& part) {
  if constexpr (std::is_same_v<Stream, Writer>)
    stream.put(part);
  else
    stream.get(part);
}

template <class Stream, class... Parts>
void all(Stream& stream, Parts&... parts) {
  (each(stream, parts), ...);
}

template <class Stream, class List, class One>
void list(Stream& stream, List& elements, const One& one) {
  if constexpr (std::is_same_v<Stream, Writer>) {
    stream.template put<std::uint64_t>(elements.size());
    for (auto& element : elements) one(element);
  } else {
    stream.get_list(elements, one);
  }
}

template <class Stream, class Place>
void place(Stream& stream, Place& of) {
  all(stream, of.file, of.mark.line, of.mark.column);
}

template <class Stream, class Fault>
void fault(Stream& stream, Fault& of) {
  all(stream, of.block, of.port, of.time);
  place(stream, of.fault.place);
  all(stream, of.fault.subject, of.fault.message.wrong, of.fault.message.cure);
  list(stream, of.fault.used_by, [&](auto& user) { place(stream, user); });
}

template <class Stream, class End>
void run_end(Stream& stream, End& end) {
  list(stream, end.faults, [&](auto& one) { fault(stream, one); });
  list(stream, end.diagnostics, [&](auto& one) { all(stream, one.block, one.text, one.time); });
  list(stream, end.loops, [&](auto& one) {
    all(stream, one.path, one.unknowns, one.instants, one.iterations, one.most, one.unsolved,
        one.first_unsolved);
  });
  std::int64_t stopped = end.stopped;
  all(stream, end.events.located, end.events.most_in_a_step, stopped, end.ticks, end.lane_ticks, end.compiled_ticks);
  if constexpr (std::is_same_v<Stream, Reader>) end.stopped = stopped != 0;
}

/// Has the result as many rows as its run can leave?
bool fits(const run::PointResult& result, const run::Job& job, const run::RunNumbers* numbers) {
  const plan::Plan& plan = job.plan_of(result.point);
  const bool one_row = run::keeps_a_row(job, numbers);
  for (std::size_t r = 0; r < result.recordings.size(); ++r) {
    const std::size_t rows = result.recordings[r].table.rows();
    if (one_row ? rows != 1 : rows > record::max_rows(plan, plan.diagram.records[r])) return false;
  }
  return true;
}

}  // namespace

std::string bytes_of(const run::PointResult& result) {
  Writer writer;
  writer.put<std::uint64_t>(result.point);
  run_end(writer, result.end);
  for (const record::Recording& recording : result.recordings) {
    writer.put<std::uint64_t>(recording.table.rows());
    for (const table::Column& column : recording.table.columns) writer.put(column.values);
  }
  return writer.take();
}

std::optional<run::PointResult> point_of(std::string_view bytes, const run::Job& job,
                                         const run::RunNumbers* numbers) {
  Reader reader(bytes);
  run::PointResult result;
  std::uint64_t point = 0;
  reader.get(point);
  if (!reader.whole() || point >= job.points.size()) return std::nullopt;
  result.point = point;
  run_end(reader, result.end);
  result.recordings = run::empty_recordings(job.plan_of(result.point), numbers);
  for (record::Recording& recording : result.recordings) {
    std::uint64_t rows = 0;
    reader.get(rows);
    for (table::Column& column : recording.table.columns) reader.get(column.values, rows);
  }
  if (!reader.whole() || !reader.at_end() || !fits(result, job, numbers)) return std::nullopt;
  return result;
}

}  // namespace stepwire::journal
