// Driver for numbers over a serial line. A frame is little-endian. It begins with the bytes A5 5A. Then come
// the number of values and a sequence number, one byte each, and the values as floats or doubles. Its end is
// a CRC-16 (polynomial 1021, begin FFFF) of all but the first two bytes.
#include <fcntl.h>
#include <sys/file.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cstring>

#include "engine/drivers/support/newest.hpp"
#include "engine/drivers/support/table.hpp"

namespace {

using stepwire::support::Channels;
using stepwire::support::Newest;
using stepwire::support::Settings;

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t most_values = 64, head = 4, tail = 2, most_bytes = head + 8 * most_values + tail;
constexpr std::uint8_t first_byte = 0xa5, second_byte = 0x5a;
constexpr int most_reads = 16;  // of one call

std::uint16_t crc_of(const std::uint8_t* bytes, std::size_t count) {
  std::uint16_t crc = 0xffff;
  for (std::size_t i = 0; i < count; ++i) {
    crc = static_cast<std::uint16_t>(crc ^ (bytes[i] << 8));
    for (int bit = 0; bit < 8; ++bit)
      crc = static_cast<std::uint16_t>((crc & 0x8000) != 0 ? (crc << 1) ^ 0x1021 : crc << 1);
  }
  return crc;
}

speed_t speed_of(std::int64_t baud) {
  const std::pair<std::int64_t, speed_t> known[] = {
      {9600, B9600},       {19200, B19200},     {38400, B38400},    {57600, B57600},
      {115200, B115200},   {230400, B230400},   {460800, B460800},  {921600, B921600},
      {1000000, B1000000}, {2000000, B2000000}, {3000000, B3000000}};
  for (const auto& [rate, speed] : known)
    if (rate == baud) return speed;
  Settings::refuse("baud", "is none that a serial line has, such as 115200");
}

/// Open line in raw mode.
class Line {
 public:
  Line(const std::string& path, speed_t speed)
      : file_(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
    termios settings{};
    if (file_ < 0 || ::flock(file_, LOCK_EX | LOCK_NB) != 0 || ::tcgetattr(file_, &settings) != 0) fail(path);
    ::cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL | CREAD;
    ::cfsetspeed(&settings, speed);
    if (::tcsetattr(file_, TCSANOW, &settings) != 0) fail(path);
  }
  ~Line() { ::close(file_); }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  int file() const { return file_; }

 private:
  [[noreturn]] void fail(const std::string& path) const {
    const std::string reason = errno == EWOULDBLOCK ? "it is in use by another loop" : std::strerror(errno);
    if (file_ >= 0) ::close(file_);
    throw std::runtime_error("the line " + path + " cannot be opened: " + reason);
  }

  int file_;
};

class SerialDevice {
 public:
  explicit SerialDevice(const Settings& settings)
      : newest_(settings.time("stale", 100e6)),
        width_(settings.word("number", {"float", "double"}) == 0 ? 4 : 8),
        line_(settings.text("line"), speed_of(settings.whole("baud", 115200))) {
    channels_.add_list(settings.text("inputs", ""), STEPWIRE_INPUT);
    channels_.add_list(settings.text("outputs", ""), STEPWIRE_OUTPUT);
    if (channels_.count(STEPWIRE_INPUT) > most_values || channels_.count(STEPWIRE_OUTPUT) > most_values)
      throw std::runtime_error("at most 64 values go in each direction");
  }

  const Channels& channels() const { return channels_; }

  void start(std::int64_t, const double* safe) {
    safe_.assign(safe, safe + channels_.count(STEPWIRE_OUTPUT));
    newest_.start(channels_.count(STEPWIRE_INPUT));
    ::tcflush(line_.file(), TCIFLUSH);
  }

  int ready() {
    if (!take_bytes()) return -1;
    return channels_.count(STEPWIRE_INPUT) == 0 || newest_.seen() > 0;
  }
  int read(double* values) {
    if (!take_bytes()) return STEPWIRE_FAILED;
    return channels_.count(STEPWIRE_INPUT) > 0 ? newest_.give(values) : STEPWIRE_OK;
  }

  /// A frame that the line does not take whole is counted; the receiver finds the next one.
  int write(const double* values) {
    const std::size_t count = safe_.size();
    if (count == 0) return STEPWIRE_OK;
    std::array<std::uint8_t, most_bytes> frame{first_byte, second_byte, static_cast<std::uint8_t>(count),
                                               ++sequence_};
    for (std::size_t i = 0; i < count; ++i) put(frame.data() + head + i * width_, values[i]);
    const std::size_t end = head + count * width_;
    const std::uint16_t crc = crc_of(frame.data() + 2, end - 2);
    std::memcpy(frame.data() + end, &crc, sizeof crc);
    const ssize_t sent = ::write(line_.file(), frame.data(), end + tail);
    if (sent < 0 && errno != EAGAIN && errno != EINTR) return STEPWIRE_FAILED;
    cut_ += sent == static_cast<ssize_t>(end + tail) ? 0 : 1;
    return STEPWIRE_OK;
  }
  int safe() { return write(safe_.data()); }
  void stop() {}
  void report(char* text, std::size_t size) const {
    newest_.report(text, size);
    const std::size_t used = std::strlen(text);
    if (cut_ > 0)
      std::snprintf(text + used, size - used, "; %llu frames were cut by a full line",
                    static_cast<unsigned long long>(cut_));
  }

 private:
  /// Takes the bytes that have come. Returns false once the line is unplugged.
  bool take_bytes() {
    for (int i = 0; i < most_reads; ++i) {
      const ssize_t got = ::read(line_.file(), bytes_.data() + filled_, bytes_.size() - filled_);
      if (got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR)) return false;
      if (got < 0) break;
      filled_ += static_cast<std::size_t>(got);
      take_frames();
    }
    return true;
  }
  void put(std::uint8_t* to, double value) const {
    const auto small = static_cast<float>(value);
    if (width_ == 4)
      std::memcpy(to, &small, sizeof small);
    else
      std::memcpy(to, &value, sizeof value);
  }
  double get(const std::uint8_t* from) const {
    float small = 0.0F;
    double value = 0.0;
    if (width_ == 4)
      std::memcpy(&small, from, sizeof small);
    else
      std::memcpy(&value, from, sizeof value);
    return width_ == 4 ? small : value;
  }

  /// Takes all whole frames. Bytes that begin none are left out one by one.
  void take_frames() {
    const std::size_t count = channels_.count(STEPWIRE_INPUT), size = head + count * width_ + tail;
    std::size_t at = 0;
    while (filled_ - at >= size) {
      const std::uint8_t* const frame = bytes_.data() + at;
      const bool begins = frame[0] == first_byte && frame[1] == second_byte && frame[2] == count;
      if (begins && take(frame, size)) {
        at += size;
      } else {
        if (begins) newest_.refuse();
        ++at;
      }
    }
    std::memmove(bytes_.data(), bytes_.data() + at, filled_ - at);
    filled_ -= at;
  }
  bool take(const std::uint8_t* frame, std::size_t size) {
    std::uint16_t crc = 0;
    std::memcpy(&crc, frame + size - tail, sizeof crc);
    if (crc != crc_of(frame + 2, size - 2 - tail)) return false;
    std::array<double, most_values> values{};
    for (std::size_t i = 0; i < channels_.count(STEPWIRE_INPUT); ++i)
      values[i] = get(frame + head + i * width_);
    newest_.take(frame[3], 256, values.data());
    return true;
  }

  Channels channels_;
  Newest newest_;
  std::size_t width_, filled_ = 0;
  Line line_;
  std::array<std::uint8_t, 2 * most_bytes> bytes_{};
  std::vector<double> safe_;
  std::uint8_t sequence_ = 0;
  std::uint64_t cut_ = 0;
};

constexpr stepwire_known_setting settings[] = {
    {"line", "device file: /dev/ttyACM0", nullptr},
    {"baud", "bits in a second", "115200"},
    {"number", "float or double", "float"},
    {"inputs", "names with units, in the order of the frame: force in N, angle in rad", ""},
    {"outputs", "names with units, in the order of the frame", ""},
    {"stale", "age from which values are stale", "100 ms"},
    {nullptr, nullptr, nullptr}};

/// Lists the lines by the names of their devices.
void list(char* text, std::size_t size) {
  stepwire::support::list_files("/dev/serial/by-id/*", text, size);
}

}  // namespace

extern "C" const stepwire_driver* stepwire_driver_v1(void) {
  static const stepwire_driver driver = stepwire::support::driver_table<SerialDevice>(
      "serial", "frames with a checksum over a serial line", settings, list);
  return &driver;
}
