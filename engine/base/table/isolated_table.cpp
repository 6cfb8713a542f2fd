#include "engine/base/table/isolated_table.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <new>

#include "engine/base/subprocess/isolated.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::table {

namespace {

constexpr std::size_t memory_of_library = std::size_t{256} << 20;
constexpr std::size_t copies = 6;  ///< memory for the columns, as a multiple of the unpacked file

/// First word of an answer.
enum class Answer : std::uint64_t { table, wrong, refused };

/// Throws IsolationError for a truncated or invalid answer.
[[noreturn]] void refuse_answer() {
  throw subprocess::IsolationError("has left no table");
}

/// Serialises numbers and texts; each text is preceded by its length.
class Sink {
 public:
  explicit Sink(int file) : file_(file) {}

  void put(const void* bytes, std::size_t count) {
    const char* at = static_cast<const char*>(bytes);
    while (count > 0) {
      const ssize_t written = ::write(file_, at, count);
      if (written <= 0) throw std::bad_alloc();  // the only reason: the file is in memory
      at += written;
      count -= static_cast<std::size_t>(written);
    }
  }
  void put(std::uint64_t number) { put(&number, sizeof number); }
  void put(const std::string& text) {
    put(text.size());
    put(text.data(), text.size());
  }
  void put(const std::vector<double>& values) {
    put(values.size());
    put(values.data(), values.size() * sizeof(double));
  }

 private:
  int file_;
};

/// Deserialises the bytes of a Sink.
class Source {
 public:
  explicit Source(int file) : file_(file) {
    const off_t end = ::lseek(file, 0, SEEK_END);
    rest_ = end > 0 ? static_cast<std::size_t>(end) : 0;
    ::lseek(file, 0, SEEK_SET);
  }

  std::uint64_t number() {
    std::uint64_t number = 0;
    take(&number, sizeof number);
    return number;
  }
  std::string text() { return list<std::string>(); }
  std::vector<double> values() { return list<std::vector<double>>(); }

 private:
  template <class List>
  List list() {
    constexpr std::size_t one = sizeof(typename List::value_type);
    const std::uint64_t count = number();
    if (count > rest_ / one) refuse_answer();
    List list(count, typename List::value_type{});
    take(list.data(), count * one);
    return list;
  }

  void take(void* to, std::size_t count) {
    if (count > rest_) refuse_answer();
    rest_ -= count;
    char* at = static_cast<char*>(to);
    while (count > 0) {
      const ssize_t got = ::read(file_, at, count);
      if (got <= 0) refuse_answer();
      at += got;
      count -= static_cast<std::size_t>(got);
    }
  }

  int file_;
  std::size_t rest_ = 0;
};

void write_table(Sink& sink, const RecordTable& table) {
  sink.put(static_cast<std::uint64_t>(Answer::table));
  sink.put(table.columns.size());
  for (const Column& column : table.columns) {
    sink.put(column.name);
    sink.put(column.unit);
    sink.put(column.values);
  }
  sink.put(table.problems.size());
  for (const auto& [column, problem] : table.problems) {
    sink.put(column);
    sink.put(problem);
  }
  sink.put(table.words.size());
  for (const auto& [column, words] : table.words) {
    sink.put(column);
    sink.put(words.size());
    for (const std::string& word : words) sink.put(word);
  }
}

void write_refusal(Sink& sink, Answer answer, const char* why) {
  sink.put(static_cast<std::uint64_t>(answer));
  sink.put(std::string(why));
}

RecordTable table_of(Source& source) {
  RecordTable table;
  for (std::uint64_t rest = source.number(); rest > 0; --rest) {
    Column column{source.text(), source.text(), source.values()};
    table.columns.push_back(std::move(column));
  }
  for (std::uint64_t rest = source.number(); rest > 0; --rest) {
    const std::string column = source.text();
    table.problems[column] = source.text();
  }
  for (std::uint64_t rest = source.number(); rest > 0; --rest) {
    std::vector<std::string>& words = table.words[source.text()];
    for (std::uint64_t more = source.number(); more > 0; --more) words.push_back(source.text());
  }
  return table;
}

RecordTable answer_of(Source source) {
  const std::uint64_t answer = source.number();
  if (answer == static_cast<std::uint64_t>(Answer::wrong)) throw TableError(source.text());
  if (answer == static_cast<std::uint64_t>(Answer::refused)) throw io::EnvironmentError(source.text());
  return table_of(source);
}

void answer(const std::function<RecordTable()>& read, int output) {
  Sink sink(output);
  try {
    write_table(sink, read());
  } catch (const TableError& error) {
    write_refusal(sink, Answer::wrong, error.what());
  } catch (const io::EnvironmentError& error) {
    write_refusal(sink, Answer::refused, error.what());
  }
}

}  // namespace

RecordTable read_isolated(const std::string& path, std::size_t file_size,
                          const std::function<RecordTable()>& read) {
  const std::chrono::seconds of_size(file_size / 10'000'000);
  const subprocess::IsolationBounds bounds{subprocess::usual_limit() + of_size,
                                           copies * max_unpacked(file_size) + memory_of_library};
  try {
    const io::Descriptor output = subprocess::call_isolated([&](int file) { answer(read, file); }, bounds);
    return answer_of(Source(output.number()));
  } catch (const subprocess::IsolationError& error) {
    throw TableError(
        fmt::format("{}: the file may be damaged: the process that reads it {}", path, error.what()));
  }
}

}  // namespace stepwire::table
