#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace stepwire::messages {

static_assert(std::endian::native == std::endian::little);

/// Serialises values: numbers as in memory (little-endian), texts and lists preceded by their length of 8
/// bytes.
class ByteWriter {
 public:
  template <class Number>
  void put(Number number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }
  void put(const std::string& text) {
    put<std::uint64_t>(text.size());
    bytes_ += text;
  }
  /// Writes numbers without a length; the reader must know their count.
  void put(const std::vector<double>& numbers) {
    bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Deserialises the bytes of a ByteWriter. If bytes are missing it returns zeros, and whole() is false from
/// then on.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <class Number>
  void get(Number& number) {
    copy(&number, sizeof(number));
  }
  void get(bool& flag) {
    std::uint8_t byte = 0;
    get(byte);
    flag = byte != 0;
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
  /// Reads a list whose elements have at least one byte each.
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

/// Writes or reads several values, depending on the kind of stream, so that each is listed only once.
template <class Stream, class... Parts>
void all(Stream& stream, Parts&... parts) {
  if constexpr (std::is_same_v<Stream, ByteWriter>)
    (stream.put(parts), ...);
  else
    (stream.get(parts), ...);
}

/// Writes or reads a list; `one` writes or reads an element.
template <class Stream, class List, class One>
void list(Stream& stream, List& elements, const One& one) {
  if constexpr (std::is_same_v<Stream, ByteWriter>) {
    stream.template put<std::uint64_t>(elements.size());
    for (auto& element : elements) one(element);
  } else {
    stream.get_list(elements, one);
  }
}

/// Writes or reads a list of numbers or texts.
template <class Stream, class List>
void plain_list(Stream& stream, List& elements) {
  list(stream, elements, [&](auto& element) { all(stream, element); });
}

}  // namespace stepwire::messages
