// The drivers by the calls of driver.h, against a peer that the test writes byte by byte.
#include <arpa/inet.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>
#include <catch2/catch.hpp>
#include <cstring>
#include <thread>

#include "engine/base/driver/open_device.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/simulate/devices/wired_device.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::driver {
namespace {

using Catch::Contains;

constexpr std::int64_t ms = 1'000'000;

OpenDevice opened(const std::string& name, const Settings& settings) {
  return OpenDevice(load_driver(driver_file(name)), settings);
}

void start(OpenDevice& device, const std::vector<double>& safe) {
  device.start(ms, safe.data());
}

std::string refusal(const std::string& name, const Settings& settings) {
  try {
    opened(name, settings);
    return "";
  } catch (const io::EnvironmentError& error) {
    return error.what();
  }
}

/// Socket of a peer on this machine.
struct Peer {
  explicit Peer(std::uint16_t other) : socket(::socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::bind(socket, reinterpret_cast<sockaddr*>(&own), sizeof own);
    socklen_t size = sizeof own;
    ::getsockname(socket, reinterpret_cast<sockaddr*>(&own), &size);
    port = ntohs(own.sin_port);
    to = own;
    to.sin_port = htons(other);
  }
  ~Peer() { ::close(socket); }

  void send(const std::string& bytes) const {
    REQUIRE(::sendto(socket, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to),
                     sizeof to) > 0);
  }
  std::string receive() const {
    char bytes[2048];
    const ssize_t size = ::recv(socket, bytes, sizeof bytes, 0);
    return {bytes, static_cast<std::size_t>(std::max<ssize_t>(0, size))};
  }

  int socket;
  std::uint16_t port = 0;
  sockaddr_in to{};
};

template <class Number>
std::string bytes_of(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::string packet(std::uint64_t sequence, const std::vector<double>& values) {
  std::string bytes = "SWU1" + bytes_of(static_cast<std::uint32_t>(values.size())) + bytes_of(sequence) +
                      bytes_of(std::int64_t{7});
  for (const double value : values) bytes += bytes_of(value);
  return bytes;
}

/// A port that was free a moment ago.
std::uint16_t free_port() {
  return Peer(1).port;
}

/// Both ends of a pseudo terminal.
struct Terminal {
  Terminal() : file(::posix_openpt(O_RDWR | O_NOCTTY)) {
    ::grantpt(file);
    ::unlockpt(file);
    path = ::ptsname(file);
    termios raw{};
    ::tcgetattr(file, &raw);
    ::cfmakeraw(&raw);
    ::tcsetattr(file, TCSANOW, &raw);
  }
  ~Terminal() { ::close(file); }
  void send(const std::string& bytes) const { REQUIRE(::write(file, bytes.data(), bytes.size()) > 0); }
  std::string receive(std::size_t count) const {
    std::string all(count, '\0');
    std::size_t got = 0;
    for (pollfd look{file, POLLIN, 0}; got<count&& ::poll(&look, 1, 2000)> 0;)
      got += static_cast<std::size_t>(std::max<ssize_t>(0, ::read(file, all.data() + got, count - got)));
    return all.substr(0, got);
  }

  int file;
  std::string path;
};

/// CRC-16 with the polynomial 1021 and the beginning FFFF, by long division of bits.
std::uint16_t crc(const std::string& text) {
  std::uint32_t rest = 0xffff;
  for (const char one : text)
    for (int bit = 7; bit >= 0; --bit) {
      const bool top = ((rest >> 15) ^ (static_cast<unsigned char>(one) >> bit)) & 1;
      rest = ((rest << 1) & 0xffff) ^ (top ? 0x1021 : 0);
    }
  return static_cast<std::uint16_t>(rest);
}

std::string frame(int sequence, const std::vector<float>& values) {
  std::string inside{static_cast<char>(values.size()), static_cast<char>(sequence)};
  for (const float value : values) inside += bytes_of(value);
  return "\xa5\x5a" + inside + bytes_of(crc(inside));
}

/// Reads until a first value comes, for two seconds at most.
std::vector<double> read_until(OpenDevice& device, double first) {
  std::vector<double> values(device.inputs().size());
  for (int look = 0; look < 2000; ++look) {
    device.read(values.data());
    if (values[0] == first) break;
    ::usleep(1000);
  }
  return values;
}

}  // namespace

TEST_CASE("a driver that is cut off is refused before it is loaded") {
  const std::string file = driver_file("file");
  const std::string bytes = io::read_file(file);
  const Scratch folder;
  for (const std::size_t part : {2, 4, 20})
    CHECK_THROWS_WITH(load_driver(folder.file("cut.so", bytes.substr(0, bytes.size() / part))),
                      Contains("cut.so is cut off"));
}

TEST_CASE("a port of udp is a whole number from 1 to 65535") {
  for (const std::string port : {"0", "70000", "-1", "5000x", ""})
    CHECK_THAT(refusal("udp", {{"listen", "127.0.0.1:" + port}, {"inputs", "force in N"}}),
               Contains("the setting 'listen' is no address with a port from 1 to 65535"));
}

TEST_CASE("packets by UDP are taken in their order; lost, old and foreign ones are counted") {
  const std::uint16_t port = free_port();
  const Peer peer(port);
  OpenDevice device = opened("udp", {{"listen", std::to_string(port)},
                                     {"to", "127.0.0.1:" + std::to_string(peer.port)},
                                     {"inputs", "force in N, angle in deg"},
                                     {"outputs", "current in A"},
                                     {"stale", "20 s"}});
  CHECK(std::string(device.inputs()[1].name) == "angle");
  CHECK(std::string(device.inputs()[1].unit) == "deg");
  start(device, {0.25});
  peer.send(packet(41, {1.0, 10.0}));
  CHECK(read_until(device, 1.0) == std::vector{1.0, 10.0});
  peer.send(packet(45, {2.0, 20.0}));
  peer.send(packet(44, {3.0, 30.0}));  // late
  peer.send(packet(46, {4.0}));        // another number of values
  peer.send("SWU");
  peer.send(packet(47, {5.0, 50.0}));
  CHECK(read_until(device, 5.0) == std::vector{5.0, 50.0});
  CHECK_THAT(device.report(), Contains("3 messages, 4 lost, 1 out of order, 2 damaged"));
}

TEST_CASE("what is sent by UDP has magic, count, rising sequence and values") {
  const std::uint16_t port = free_port();
  const Peer peer(port);
  OpenDevice device = opened("udp", {{"listen", std::to_string(port)},
                                     {"to", "127.0.0.1:" + std::to_string(peer.port)},
                                     {"outputs", "current in A"}});
  start(device, {0.25});
  const double current = 0.5;
  CHECK(device.write(&current) == STEPWIRE_OK);
  CHECK(device.safe() == STEPWIRE_OK);
  const std::string first = peer.receive(), second = peer.receive();
  CHECK(first.substr(0, 16) == packet(1, {0.5}).substr(0, 16));
  CHECK(first.substr(24) == bytes_of(0.5));
  CHECK(second.substr(0, 16) == packet(2, {0.25}).substr(0, 16));
  CHECK(second.substr(24) == bytes_of(0.25));
}

TEST_CASE("a device by UDP is ready once a packet of its own has come since the start") {
  const std::uint16_t port = free_port();
  const Peer peer(port);
  OpenDevice device = opened("udp", {{"listen", std::to_string(port)}, {"inputs", "force in N"}});
  peer.send(packet(1, {1.0}));
  start(device, {});
  CHECK_FALSE(device.is_ready());
  peer.send("SWU?");
  CHECK_FALSE(device.is_ready());
  peer.send(packet(2, {2.0}));
  CHECK(read_until(device, 2.0) == std::vector{2.0});
  CHECK(device.is_ready());
}

TEST_CASE("values by UDP that are older than stated are stale, and a restarted sender is taken then") {
  const std::uint16_t port = free_port();
  const Peer peer(port);
  OpenDevice device =
      opened("udp", {{"listen", std::to_string(port)}, {"inputs", "force in N"}, {"stale", "20 ms"}});
  start(device, {});
  peer.send(packet(1000, {1.0}));
  read_until(device, 1.0);
  ::usleep(40'000);
  double force = 0.0;
  CHECK(device.read(&force) == STEPWIRE_STALE);
  CHECK(force == 1.0);
  peer.send(packet(1, {2.0}));
  CHECK(read_until(device, 2.0) == std::vector{2.0});
}

TEST_CASE("a device by UDP can be the clock: it waits for packets and counts those that are lost") {
  const std::uint16_t port = free_port();
  const Peer peer(port);
  OpenDevice device =
      opened("udp", {{"listen", std::to_string(port)}, {"inputs", "force in N"}, {"stale", "20 s"}});
  REQUIRE(device.is_clock());
  start(device, {});
  CHECK(device.wait(ms) == 0);
  peer.send(packet(1, {1.0}));
  CHECK(device.wait(5000 * ms) == 1);
  peer.send(packet(4, {1.0}));
  CHECK(device.wait(5000 * ms) == 3);
}

TEST_CASE("samples of a clock with another period than the loop are told") {
  const std::uint16_t port = free_port();
  const Peer peer(port);
  OpenDevice device =
      opened("udp", {{"listen", std::to_string(port)}, {"inputs", "force in N"}, {"stale", "20 s"}});
  start(device, {});
  std::thread sender([&] {
    for (std::uint64_t i = 1; i <= 15; ++i) {
      peer.send(packet(i, {1.0}));
      ::usleep(4'000);
    }
  });
  devices::DeviceClock clock(device, ms);
  for (std::int64_t tick = 1; tick <= 13; ++tick) clock.sleep_until(clock.now() + ms);
  sender.join();
  CHECK_THAT(clock.other_period(), Contains("a period of the loop is 1 ms"));
}

TEST_CASE("wrong settings of UDP are refused in a sentence") {
  CHECK_THAT(refusal("udp", {{"inputs", "a"}}), Contains("the setting 'listen' is missing"));
  CHECK_THAT(refusal("udp", {{"listen", "x:y"}, {"inputs", "a"}}),
             Contains("'listen' is no address with a port"));
  CHECK_THAT(refusal("udp", {{"listen", "5000"}, {"outputs", "a"}}),
             Contains("outputs need the setting 'to'"));
  CHECK_THAT(refusal("udp", {{"listen", "5000"}, {"inputs", "a"}, {"stale", "1"}}),
             Contains("'stale' needs a unit"));
}

TEST_CASE("the checksum of the test is the published one") {
  CHECK(crc("123456789") == 0x29b1);
}

TEST_CASE("frames over a serial line are found among other bytes; damaged and lost ones are counted") {
  const Terminal line;
  OpenDevice device =
      opened("serial", {{"line", line.path}, {"inputs", "force in N, speed in m/s"}, {"stale", "20 s"}});
  start(device, {});
  line.send("boot\xa5\r\n" + frame(255, {1.5F, -2.0F}));
  CHECK(read_until(device, 1.5) == std::vector{1.5, -2.0});
  std::string bad = frame(0, {9.0F, 9.0F});
  bad[6] = static_cast<char>(bad[6] ^ 1);
  const std::string next = frame(2, {2.5F, 0.0F});
  line.send(bad + next.substr(0, 5));
  ::usleep(5000);
  line.send(next.substr(5));
  CHECK(read_until(device, 2.5) == std::vector{2.5, 0.0});
  CHECK_THAT(device.report(), Contains("2 messages, 2 lost, 0 out of order, 1 damaged"));
}

TEST_CASE("what is written to a serial line are frames with a checksum") {
  const Terminal line;
  OpenDevice device = opened("serial", {{"line", line.path}, {"outputs", "current in A"}});
  start(device, {0.25});
  const double current = 0.5;
  CHECK(device.write(&current) == STEPWIRE_OK);
  CHECK(device.safe() == STEPWIRE_OK);
  CHECK(line.receive(20) == frame(1, {0.5F}) + frame(2, {0.25F}));
}

TEST_CASE("a line that is gone fails, and one that is not there is refused") {
  auto line = std::make_unique<Terminal>();
  OpenDevice device =
      opened("serial", {{"line", line->path}, {"inputs", "force in N"}, {"outputs", "current"}});
  start(device, {0.0});
  line.reset();
  double force = 0.0;
  CHECK(device.read(&force) == STEPWIRE_FAILED);
  CHECK_THAT(refusal("serial", {{"line", "/dev/stepwire-none"}}), Contains("cannot be opened: No such file"));
  CHECK_THAT(refusal("serial", {{"line", "/dev/null"}, {"baud", "7"}}),
             Contains("'baud' is none that a serial line has"));
}

TEST_CASE("two processes share memory: the client has the channels of the host, and either side may end") {
  const std::string name = "stepwire-driver-test-" + std::to_string(::getpid());
  const Settings of_host{{"name", name},
                         {"role", "host"},
                         {"inputs", "current in A"},
                         {"outputs", "force in N, knob"},
                         {"stale", "20 s"}};
  CHECK_THAT(refusal("shared", {{"name", name}}), Contains("there is no shared memory /" + name));
  auto host = std::make_unique<OpenDevice>(load_driver(driver_file("shared")), of_host);
  start(*host, {0.0, 0.0});
  CHECK_THAT(refusal("shared", of_host), Contains("is that of the running process"));
  OpenDevice client = opened("shared", {{"name", name}, {"stale", "20 ms"}});
  REQUIRE(client.inputs().size() == 2);
  CHECK(std::string(client.inputs()[0].name) + client.inputs()[0].unit == "forceN");
  CHECK(std::string(client.outputs()[0].name) + client.outputs()[0].unit == "currentA");
  start(client, {0.25});
  const double seen[] = {1.0, 2.0}, current = 0.5;
  CHECK_FALSE(client.is_ready());
  CHECK(host->write(seen) == STEPWIRE_OK);
  CHECK(client.is_ready());
  std::vector<double> values(2);
  CHECK(client.read(values.data()) == STEPWIRE_OK);
  CHECK(values == std::vector{1.0, 2.0});
  double got = 0.0;
  client.write(&current);
  host->read(&got);
  CHECK(got == 0.5);
  client.safe();
  host->read(&got);
  CHECK(got == 0.25);
  host.reset();
  ::usleep(40'000);
  CHECK(client.read(values.data()) == STEPWIRE_STALE);
}

}  // namespace stepwire::driver
