// Driver for packets of doubles by UDP. A packet is little-endian: the text "SWU1", the number of values (4
// bytes), a sequence number (8), the sender's time [ns] (8), and the values (8 each).
#include <arpa/inet.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <utility>

#include "engine/drivers/support/newest.hpp"
#include "engine/drivers/support/table.hpp"

namespace {

using stepwire::support::Channels;
using stepwire::support::monotonic;
using stepwire::support::Newest;
using stepwire::support::Settings;

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t most_values = 128;
constexpr int most_packets = 4096;  // more than a socket keeps

struct Packet {
  char magic[4] = {'S', 'W', 'U', '1'};
  std::uint32_t count = 0;
  std::uint64_t sequence = 0;
  std::int64_t time = 0;
  double values[most_values] = {};
};

constexpr std::size_t size_of(std::size_t count) {
  return offsetof(Packet, values) + count * sizeof(double);
}

[[noreturn]] void refuse_address(const char* key) {
  Settings::refuse(key, "is no address with a port from 1 to 65535, such as 192.168.0.2:5000");
}

/// Splits "host:port"; a port alone has the host 127.0.0.1.
sockaddr_in address_of(const std::string& text, const char* key) {
  const auto colon = text.rfind(':');
  const std::string host = colon == std::string::npos ? "127.0.0.1" : text.substr(0, colon);
  const std::string port = colon == std::string::npos ? text : text.substr(colon + 1);
  char* end = nullptr;
  const long number = std::strtol(port.c_str(), &end, 10);
  if (*end != 0 || number < 1 || number > 65'535) refuse_address(key);
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_family = AF_INET;
  wanted.ai_socktype = SOCK_DGRAM;
  wanted.ai_flags = AI_NUMERICSERV;
  if (::getaddrinfo(host.c_str(), port.c_str(), &wanted, &found) != 0 || !found) refuse_address(key);
  sockaddr_in address{};
  std::memcpy(&address, found->ai_addr, sizeof address);
  ::freeaddrinfo(found);
  return address;
}

class UdpDevice {
 public:
  explicit UdpDevice(const Settings& settings) : newest_(settings.time("stale", 100e6)) {
    channels_.add_list(settings.text("inputs", ""), STEPWIRE_INPUT);
    channels_.add_list(settings.text("outputs", ""), STEPWIRE_OUTPUT);
    if (channels_.count(STEPWIRE_INPUT) > most_values || channels_.count(STEPWIRE_OUTPUT) > most_values)
      throw std::runtime_error("at most 128 values go in each direction");
    has_peer_ = settings.has("to");
    if (has_peer_) peer_ = address_of(settings.text("to"), "to");
    if (!has_peer_ && channels_.count(STEPWIRE_OUTPUT) > 0)
      throw std::runtime_error("outputs need the setting 'to'");
    listen_at(address_of(settings.text("listen"), "listen"));
  }
  ~UdpDevice() {
    if (socket_ >= 0) ::close(socket_);
  }
  UdpDevice(const UdpDevice&) = delete;
  UdpDevice& operator=(const UdpDevice&) = delete;

  const Channels& channels() const { return channels_; }

  void start(std::int64_t, const double* safe) {
    out_.count = static_cast<std::uint32_t>(channels_.count(STEPWIRE_OUTPUT));
    safe_.assign(safe, safe + out_.count);
    newest_.start(channels_.count(STEPWIRE_INPUT));
    while (::recv(socket_, &in_, sizeof in_, MSG_DONTWAIT) >= 0 || errno == ECONNREFUSED) {
    }  // what came before the start is old
  }

  int ready() {
    take_packets();
    return channels_.count(STEPWIRE_INPUT) == 0 || newest_.seen() > 0;
  }
  int read(double* values) {
    take_packets();
    return channels_.count(STEPWIRE_INPUT) > 0 ? newest_.give(values) : STEPWIRE_OK;
  }

  /// A receiver that is not there yet is no failure of the sender.
  int write(const double* values) {
    if (out_.count == 0) return STEPWIRE_OK;
    std::copy_n(values, out_.count, out_.values);
    ++out_.sequence;
    out_.time = monotonic();
    const ssize_t sent = ::sendto(socket_, &out_, size_of(out_.count), MSG_DONTWAIT | MSG_NOSIGNAL,
                                  reinterpret_cast<const sockaddr*>(&peer_), sizeof peer_);
    const bool may_pass = errno == ECONNREFUSED || errno == EAGAIN || errno == ENOBUFS;
    return sent >= 0 || may_pass ? STEPWIRE_OK : STEPWIRE_FAILED;
  }
  int safe() { return write(safe_.data()); }

  int wait(std::int64_t limit) {
    const std::int64_t end = monotonic() + limit;
    const std::uint64_t before = newest_.seen() + newest_.lost();
    while (newest_.seen() + newest_.lost() == before) {
      const std::int64_t left = end - monotonic();
      pollfd look{socket_, POLLIN, 0};
      const timespec time{static_cast<time_t>(left / 1'000'000'000), static_cast<long>(left % 1'000'000'000)};
      if (left <= 0 || ::ppoll(&look, 1, &time, nullptr) == 0) return 0;
      while (receive()) {
      }
    }
    return static_cast<int>(std::min<std::uint64_t>(1'000'000, newest_.seen() + newest_.lost() - before));
  }

  void stop() {}
  void report(char* text, std::size_t size) const {
    if (channels_.count(STEPWIRE_INPUT) > 0)
      newest_.report(text, size);
    else
      std::snprintf(text, size, "%llu messages sent", static_cast<unsigned long long>(out_.sequence));
  }

 private:
  void listen_at(const sockaddr_in& address) {
    socket_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (socket_ < 0 || ::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
      const std::string reason = std::strerror(errno);
      if (socket_ >= 0) ::close(std::exchange(socket_, -1));
      throw std::runtime_error("the address of 'listen' cannot be used: " + reason);
    }
  }

  void take_packets() {
    for (int i = 0; i < most_packets && receive(); ++i) {
    }
  }
  /// Takes one waiting packet. False where none waits.
  bool receive() {
    sockaddr_in from{};
    socklen_t length = sizeof from;
    const ssize_t size = ::recvfrom(socket_, &in_, sizeof in_, MSG_DONTWAIT | MSG_TRUNC,
                                    reinterpret_cast<sockaddr*>(&from), &length);
    if (size < 0) return errno == ECONNREFUSED;
    const std::size_t count = channels_.count(STEPWIRE_INPUT);
    const bool is_ours = std::memcmp(in_.magic, Packet().magic, sizeof in_.magic) == 0 &&
                         in_.count == count && static_cast<std::size_t>(size) == size_of(count);
    const bool is_peer = !has_peer_ || from.sin_addr.s_addr == peer_.sin_addr.s_addr;
    if (is_ours && is_peer && count > 0)
      newest_.take(in_.sequence, 0, in_.values);
    else
      newest_.refuse();
    return true;
  }

  Channels channels_;
  Newest newest_;
  int socket_ = -1;
  bool has_peer_ = false;
  sockaddr_in peer_{};
  Packet in_, out_;
  std::vector<double> safe_;
};

constexpr stepwire_known_setting settings[] = {
    {"listen", "port of this machine, or address:port", nullptr},
    {"to", "address:port that gets the outputs; inputs are taken from this address alone", ""},
    {"inputs", "names with units, in the order of the packet: force in N, angle in rad", ""},
    {"outputs", "names with units, in the order of the packet", ""},
    {"stale", "age from which values are stale", "100 ms"},
    {nullptr, nullptr, nullptr}};

}  // namespace

extern "C" const stepwire_driver* stepwire_driver_v1(void) {
  static const stepwire_driver driver =
      stepwire::support::driver_table<UdpDevice>("udp", "packets of doubles over a network", settings);
  return &driver;
}
