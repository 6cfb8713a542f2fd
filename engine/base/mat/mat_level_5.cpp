#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "engine/base/mat/mat_content.hpp"
#include "engine/base/mat/mat_elements.hpp"
#include "engine/base/mat/mat_unreadable.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::mat {
namespace {

class Inflation {
 public:
  explicit Inflation(std::string_view packed) : packed_(packed) {
    if (::inflateInit(&stream_) != Z_OK) throw table::TableError("there is no memory to unpack it");
  }
  ~Inflation() { ::inflateEnd(&stream_); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  /// Decompresses up to `size` bytes and returns their number.
  std::size_t fill(char* space, std::size_t size) {
    std::size_t filled = 0;
    while (filled < size && !ended_) {
      feed();
      const std::size_t room = std::min(size - filled, max_at_once);
      stream_.next_out = reinterpret_cast<Bytef*>(space + filled);
      stream_.avail_out = static_cast<uInt>(room);
      const int state = ::inflate(&stream_, Z_NO_FLUSH);
      const std::size_t got = room - stream_.avail_out;
      filled += got;
      ended_ = state == Z_STREAM_END;
      if ((state != Z_OK && !ended_) || (got == 0 && !ended_ && stream_.avail_in == 0 && packed_.empty()))
        throw table::TableError("what is packed is damaged or cut off");
    }
    return filled;
  }

  /// True once the end of the stream has been read, which includes a correct checksum.
  bool ended() const { return ended_; }

 private:
  static constexpr std::size_t max_at_once = 1 << 30;

  void feed() {
    if (stream_.avail_in > 0) return;
    const std::size_t count = std::min(packed_.size(), max_at_once);
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed_.data()));  // zlib only reads it
    stream_.avail_in = static_cast<uInt>(count);
    packed_.remove_prefix(count);
  }

  std::string_view packed_;
  z_stream stream_{};
  bool ended_ = false;
};

/// Decompresses the first `most` bytes of a zlib stream. Throws TableError for a damaged stream.
std::string inflate_start(std::string_view packed, std::size_t most) {
  std::string start(most, '\0');
  start.resize(Inflation(packed).fill(start.data(), most));
  return start;
}

/// Decompresses a zlib stream of `size` bytes. Throws TableError for damage, a wrong checksum or another
/// size.
std::string inflate_all(std::string_view packed, std::size_t size) {
  std::string all(size + 1, '\0');  // one byte more, so that the end of the stream is read
  Inflation inflation(packed);
  const std::size_t got = inflation.fill(all.data(), all.size());
  if (got != size || !inflation.ended())
    throw table::TableError("what is packed has not the size that it should have");
  all.resize(size);
  return all;
}

constexpr std::size_t file_header = 128;
constexpr std::size_t longest_head = 4096;  // flags, dimensions and name of a matrix

enum ArrayClass : unsigned {
  cell = 1,
  structure = 2,
  object = 3,
  text = 4,
  sparse = 5,
  first_number = 6,
  single = 7,
  first_integer = 8,
  last_number = 15,
  function = 16,
  opaque = 17  ///< objects of newer classes, such as timeseries
};

/// Header of a matrix.
struct Head {
  unsigned type = 0;  ///< its ArrayClass
  bool complex = false;
  std::vector<std::size_t> size;
  std::string name;

  std::string class_name{};  ///< of an opaque object

  bool is_number() const { return type >= first_number && type <= last_number && mat_count(size) > 0; }
  bool is_real() const { return is_number() && !complex; }
  bool is_list(std::string_view wanted) const { return type == cell && name == wanted; }
  bool is_structure() const { return type == structure && mat_count(size) <= max_structs; }
  bool counts() const {
    return !name.empty() && (is_real() || is_structure() || is_list("names") || is_list("units"));
  }
};

/// Returns the message about a variable that is not a real array; empty for a text.
std::string problem_of(const Head& head, const std::string& name) {
  if (head.is_number() && head.complex) return unreadable_text(name, MatUnreadable::complex);
  switch (head.type) {
    case cell:
      return unreadable_text(name, MatUnreadable::cell);
    case sparse:
      return unreadable_text(name, MatUnreadable::sparse);
    case function:
      return unreadable_text(name, MatUnreadable::function);
    case structure:
      return unreadable_text(name, MatUnreadable::struct_array);
    case object:
    case opaque:
      return unreadable_text(name, MatUnreadable::object, head.class_name);
    default:
      return "";
  }
}

/// Reads the header of an opaque object: its name, type system and class.
void read_opaque(MatElements& parts, Head& head) {
  head.name = parts.next().bytes;
  parts.next();
  if (!parts.empty()) head.class_name = parts.next().bytes;
}

Head head_of(MatElements& parts) {
  Head head;
  const MatElement flags = parts.next();
  if (flags.type != MatElement::of(MatNumber::uint32) || flags.bytes.size() != 8)
    throw table::TableError("a variable does not begin with its type");
  const auto flag = static_cast<std::uint32_t>(parts.numbers(flags).front());
  head.type = flag & 0xFF;
  head.complex = (flag & 0x800) != 0;
  if (head.type == opaque) return read_opaque(parts, head), head;
  const MatElement size = parts.next();
  if (size.type != MatElement::of(MatNumber::int32) || size.bytes.size() < 8)
    throw table::TableError("the dimensions of a variable are damaged");
  for (const double count : parts.numbers(size)) {
    if (count < 0.0) throw table::TableError("a dimension of a variable is below 0");
    head.size.push_back(static_cast<std::size_t>(count));
  }
  const MatElement name = parts.next();
  if (name.type != MatElement::of(MatNumber::int8) && name.type != MatElement::of(MatNumber::uint8) &&
      name.type != MatElement::utf8)
    throw table::TableError("the name of a variable is damaged");
  head.name = name.bytes.substr(0, name.bytes.find('\0'));
  return head;
}

std::string size_text(const std::vector<std::size_t>& size) {
  return fmt::format("{}", fmt::join(size, " x "));
}

/// Decodes the values. Numbers may be stored in a smaller type than the variable's, but integers only as
/// integers.
std::vector<double> values_of(const Head& head, MatElements& parts) {
  const MatElement element = parts.next();
  const auto kind = static_cast<MatNumber>(element.type);
  const std::size_t one = mat_number_size(kind);
  const bool broken = kind == MatNumber::float32 || kind == MatNumber::float64;
  if (one == 0 || (broken && head.type >= first_integer))
    throw table::TableError(fmt::format("its numbers are of type {}, which they cannot be", element.type));
  if (element.bytes.size() != mat_count(head.size) * one)
    throw table::TableError(fmt::format("it is {} and has {} of numbers, not {}", size_text(head.size),
                                        text::counted(element.bytes.size(), "byte"),
                                        mat_count(head.size) * one));
  std::vector<double> values = parts.numbers(element);
  if (head.type == single)
    for (double& value : values) value = static_cast<double>(static_cast<float>(value));
  return values;
}

std::string text_of(MatElements cell) {
  if (cell.empty()) return "";
  const Head head = head_of(cell);
  return head.type == text && !cell.empty() ? mat_text(cell, cell.next()) : "";
}

std::vector<std::string> texts_of(const Head& head, MatElements& parts) {
  const std::size_t count = mat_count(head.size);
  std::vector<std::string> texts;
  for (; texts.size() < count && !parts.empty();) {
    const MatElement cell = parts.next();
    if (cell.type != MatElement::matrix) throw table::TableError("a cell is none");
    texts.push_back(text_of(parts.inside(cell)));
  }
  if (texts.size() != count)
    throw table::TableError(
        fmt::format("it is {} and has {}", size_text(head.size), text::counted(texts.size(), "cell")));
  return texts;
}

/// Reads the field names of a struct: their fixed length, then the names padded with zeros.
std::vector<std::string> fields_of(MatElements& parts) {
  const std::vector<double> room = parts.numbers(parts.next());
  const MatElement names = parts.next();
  if (room.size() != 1 || !(room[0] >= 1.0) || names.bytes.size() % static_cast<std::size_t>(room[0]) != 0)
    throw table::TableError("the names of its fields are damaged");
  const auto length = static_cast<std::size_t>(room[0]);
  std::vector<std::string> fields;
  for (std::size_t at = 0; at < names.bytes.size(); at += length) {
    const std::string_view one = names.bytes.substr(at, length);
    fields.emplace_back(one.substr(0, one.find('\0')));
  }
  return fields;
}

/// Runs an action and adds the name of the variable to its error.
template <class Action>
auto named(const Head& head, const Action& action) {
  try {
    return action();
  } catch (const table::TableError& error) {
    throw table::TableError(fmt::format("'{}' is damaged: {}", head.name, error.what()));
  }
}

class Level5 {
 public:
  Level5(std::string_view file, bool swap)
      : swap_(swap),
        budget_(table::max_unpacked(file.size())),
        most_(budget_),
        elements_(file.substr(file_header), swap) {}

  MatContent read() {
    while (!elements_.empty()) {
      const MatElement element = elements_.next();
      if (element.type != MatElement::matrix && element.type != MatElement::packed)
        throw table::TableError(
            fmt::format("a data element is of type {}, which is no variable", element.type));
      element.type == MatElement::packed ? unpack(element.bytes) : take(elements_.inside(element));
    }
    return std::move(content_);
  }

 private:
  /// Decompresses a variable; only the header is decompressed where the variable is not read.
  void unpack(std::string_view packed) {
    const std::string start = inflate_start(packed, longest_head);
    const MatElement tag = MatElements(start, swap_).tag();
    if (tag.type != MatElement::matrix) throw table::TableError("what is packed is no variable");
    MatElements front(std::string_view(start).substr(8), swap_);
    const Head head = head_of(front);
    if (!head.counts()) return note_problem(head, head.name);
    const std::size_t size = 8 + tag.length;
    if (size > budget_)
      throw table::TableError(
          fmt::format("'{}' unpacks to {} MB, and what lies before it to {} MB; a file of this size may "
                      "unpack to {} MB in all",
                      head.name, size >> 20, (most_ - budget_) >> 20, most_ >> 20));
    budget_ -= size;
    const std::string all = named(head, [&] { return inflate_all(packed, size); });
    take(MatElements(std::string_view(all).substr(8), swap_));
  }

  void note_problem(const Head& head, const std::string& name) {
    if (head.name.empty() && name.empty()) return;
    if (std::string problem = problem_of(head, name); !problem.empty())
      content_.problems.push_back({name, std::move(problem)});
  }

  void take(MatElements parts) {
    if (parts.empty()) return;
    const Head head = head_of(parts);
    if (!head.counts()) return note_problem(head, head.name);
    named(head, [&] {
      if (head.type == cell)
        (head.name == "names" ? content_.names : content_.units) = texts_of(head, parts);
      else
        take_value(head, parts, head.name, 0);
      return 0;
    });
  }

  /// Reads a variable, or a field of a struct by its path.
  void take_value(const Head& head, MatElements& parts, const std::string& path, std::size_t depth) {
    if (head.is_real()) return content_.variables.push_back({path, head.size, values_of(head, parts)});
    if (head.is_structure()) return take_fields(head, parts, path, depth);
    if (depth == 0 || (head.type != cell && head.type != text)) note_problem(head, path);
  }

  void take_fields(const Head& head, MatElements& parts, const std::string& path, std::size_t depth) {
    if (depth > max_depth)
      throw table::TableError(fmt::format("its structs are deeper than {} in each other", max_depth));
    const std::vector<std::string> fields = fields_of(parts);
    const std::size_t count = mat_count(head.size);
    for (std::size_t i = 0; i < count; ++i)
      for (const std::string& field : fields) {
        const MatElement value = parts.next();
        if (value.type != MatElement::matrix) throw table::TableError("a field is no array");
        MatElements inside = parts.inside(value);
        if (inside.empty()) continue;
        const Head of_field = head_of(inside);
        take_value(of_field, inside, fmt::format("{}.{}", mat_element(path, i, count), field), depth + 1);
      }
  }

  bool swap_;
  std::size_t budget_, most_;
  MatElements elements_;
  MatContent content_;
};

}  // namespace

MatContent read_mat_level_5(std::string_view file, bool swap) {
  return Level5(file, swap).read();
}

}  // namespace stepwire::mat
