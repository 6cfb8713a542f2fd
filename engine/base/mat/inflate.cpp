#include "engine/base/mat/inflate.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>

#include "engine/base/table/table_file.hpp"

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

}  // namespace

std::string inflate_start(std::string_view packed, std::size_t most) {
  std::string start(most, '\0');
  start.resize(Inflation(packed).fill(start.data(), most));
  return start;
}

std::string inflate_all(std::string_view packed, std::size_t size) {
  std::string all(size + 1, '\0');  // one byte more, so that the end of the stream is read
  Inflation inflation(packed);
  const std::size_t got = inflation.fill(all.data(), all.size());
  if (got != size || !inflation.ended())
    throw table::TableError("what is packed has not the size that it should have");
  all.resize(size);
  return all;
}

}  // namespace stepwire::mat
