// Driver for shared memory between processes: one is the host, which creates the segment, the other its
// client.
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "engine/drivers/shared/segment.h"
#include "engine/drivers/support/table.hpp"

namespace {

using stepwire::support::Channels;
using stepwire::support::Settings;

std::int64_t now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

std::string failure(const std::string& what) {
  return what + ": " + std::strerror(errno);
}

bool is_alive(std::int64_t process) {
  return process > 0 && (::kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH);
}

/// Mapped segment; its host removes the name at the end.
class Segment {
 public:
  Segment(std::string name, bool is_host) : name_(std::move(name)), is_host_(is_host) {
    if (name_.empty() || name_.front() != '/') name_ = "/" + name_;
    if (is_host_) refuse_living_host();
    const int file = ::shm_open(name_.c_str(),
                                is_host_ ? O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC : O_RDWR | O_CLOEXEC, 0600);
    if (file < 0) refuse_open();
    if (!is_host_ && ::flock(file, LOCK_EX | LOCK_NB) != 0) {
      ::close(file);
      throw std::runtime_error("the shared memory " + name_ + " is in use by another loop");
    }
    map(file);
    file_ = file;  // which keeps the lock
  }
  ~Segment() {
    ::close(file_);
    if (!memory_) return;
    (is_host_ ? memory_->host : memory_->client) = 0;
    ::munmap(memory_, sizeof(stepwire_segment));
    if (is_host_) ::shm_unlink(name_.c_str());
  }
  Segment(const Segment&) = delete;
  Segment& operator=(const Segment&) = delete;

  stepwire_segment& operator*() const { return *memory_; }
  stepwire_segment* operator->() const { return memory_; }

 private:
  void map(int file) {
    struct stat status {};
    const bool sized = is_host_ ? ::ftruncate(file, sizeof(stepwire_segment)) == 0
                                : ::fstat(file, &status) == 0 &&
                                      status.st_size == static_cast<off_t>(sizeof(stepwire_segment));
    void* const memory = sized ? ::mmap(nullptr, sizeof(stepwire_segment), PROT_READ | PROT_WRITE,
                                        MAP_SHARED | MAP_POPULATE, file, 0)
                               : MAP_FAILED;
    if (memory == MAP_FAILED) {
      ::close(file);
      throw std::runtime_error("the shared memory " + name_ + " has another layout or cannot be mapped");
    }
    memory_ = static_cast<stepwire_segment*>(memory);
  }
  [[noreturn]] void refuse_open() const {
    if (is_host_) throw std::runtime_error(failure("the shared memory " + name_ + " cannot be created"));
    if (errno != ENOENT)
      throw std::runtime_error(failure("the shared memory " + name_ + " cannot be opened"));
    throw std::runtime_error("there is no shared memory " + name_ +
                             "; its host, such as 'stepwire rig', is to be started first");
  }
  /// Removes the segment of a host that has ended without doing so.
  void refuse_living_host() const {
    const int file = ::shm_open(name_.c_str(), O_RDONLY | O_CLOEXEC, 0);
    if (file < 0) return;
    std::int64_t head[2] = {0, 0};
    const bool read = ::pread(file, head, sizeof head, 0) == static_cast<ssize_t>(sizeof head);
    ::close(file);
    if (read && is_alive(head[1]))
      throw std::runtime_error("the shared memory " + name_ + " is that of the running process " +
                               std::to_string(head[1]));
    ::shm_unlink(name_.c_str());
  }

  std::string name_;
  bool is_host_;
  int file_ = -1;
  stepwire_segment* memory_ = nullptr;
};

class SharedDevice {
 public:
  explicit SharedDevice(const Settings& settings)
      : is_host_(settings.word("role", {"client", "host"}) == 1),
        stale_(settings.time("stale", 100e6)),
        segment_(settings.text("name"), is_host_) {
    if (is_host_)
      create(settings);
    else
      join();
  }

  const Channels& channels() const { return channels_; }

  void start(std::int64_t, const double* safe) {
    safe_.assign(safe, safe + channels_.count(STEPWIRE_OUTPUT));
    last_.assign(channels_.count(STEPWIRE_INPUT), 0.0);
    changed_ = now();
    (is_host_ ? segment_->host : segment_->client) = ::getpid();
    watches_host_ = !is_host_ && segment_->host != 0 && is_alive(segment_->host);
  }

  int ready() {
    std::int64_t time = 0;
    return last_.empty() || stepwire_get(&from(), last_.data(), last_.size(), &time) != 0;
  }
  /// The age is that of the last change that was seen, since the other side may have another clock.
  int read(double* values) {
    std::int64_t time = 0;
    const std::uint64_t beat = stepwire_get(&from(), values, last_.size(), &time);
    if (beat != 0)
      std::copy_n(values, last_.size(), last_.data());
    else
      std::copy_n(last_.data(), last_.size(), values);
    if (beat != 0 && beat != seen_) {
      seen_ = beat;
      ++changes_;
      changed_ = now();
    }
    age_ = now() - changed_;
    return age_ > stale_ ? STEPWIRE_STALE : STEPWIRE_OK;
  }
  int write(const double* values) {
    stepwire_put(&to(), values, safe_.size(), now());
    return has_other_side() ? STEPWIRE_OK : STEPWIRE_FAILED;
  }
  int safe() {
    stepwire_put(&to(), safe_.data(), safe_.size(), now());
    return STEPWIRE_OK;
  }
  void stop() {}
  void report(char* text, std::size_t size) const {
    std::snprintf(text, size, "%llu changes seen, the last one %.3f ms old",
                  static_cast<unsigned long long>(changes_), static_cast<double>(age_) * 1e-6);
  }

 private:
  /// False once a host that lived at the start has ended. Its process is looked at once in a number of
  /// writes.
  bool has_other_side() {
    constexpr int between_looks = 64;
    if (!watches_host_) return true;
    const std::int64_t host = __atomic_load_n(&segment_->host, __ATOMIC_ACQUIRE);
    return host != 0 && (++writes_ % between_looks != 0 || is_alive(host));
  }
  stepwire_numbers& to() const { return is_host_ ? segment_->to_client : segment_->to_host; }
  stepwire_numbers& from() const { return is_host_ ? segment_->to_host : segment_->to_client; }

  void create(const Settings& settings) {
    channels_.add_list(settings.text("inputs", ""), STEPWIRE_INPUT);
    channels_.add_list(settings.text("outputs", ""), STEPWIRE_OUTPUT);
    std::array<std::size_t, 2> next{0, 0};
    for (const stepwire_channel& one : channels_.table()) {
      const bool is_input = one.direction == STEPWIRE_INPUT;
      const std::size_t index = next[is_input ? 0 : 1]++;
      if (index >= STEPWIRE_SEGMENT_MOST)
        throw std::runtime_error("at most 64 channels go in each direction");
      set_label((is_input ? segment_->to_host_labels : segment_->to_client_labels)[index], one);
    }
    segment_->to_host.count = static_cast<std::uint32_t>(next[0]);
    segment_->to_client.count = static_cast<std::uint32_t>(next[1]);
    segment_->host = ::getpid();
    __atomic_store_n(&segment_->magic, STEPWIRE_SEGMENT_MAGIC, __ATOMIC_RELEASE);
  }
  static void set_label(stepwire_label& label, const stepwire_channel& channel) {
    if (std::strlen(channel.name) >= sizeof label.name || std::strlen(channel.unit) >= sizeof label.unit)
      throw std::runtime_error(std::string("the name or unit of '") + channel.name +
                               "' is too long for a segment");
    std::strcpy(label.name, channel.name);
    std::strcpy(label.unit, channel.unit);
  }
  void join() {
    if (__atomic_load_n(&segment_->magic, __ATOMIC_ACQUIRE) != STEPWIRE_SEGMENT_MAGIC)
      throw std::runtime_error("the shared memory is not that of a host of this version");
    take_labels(segment_->to_client_labels, segment_->to_client.count, STEPWIRE_INPUT);
    take_labels(segment_->to_host_labels, segment_->to_host.count, STEPWIRE_OUTPUT);
  }
  void take_labels(const stepwire_label* labels, std::size_t count, int direction) {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min<std::size_t>(count, STEPWIRE_SEGMENT_MOST); ++i)
      channels_.add(std::string(labels[i].name, ::strnlen(labels[i].name, sizeof labels[i].name)), direction,
                    "number", std::string(labels[i].unit, ::strnlen(labels[i].unit, sizeof labels[i].unit)),
                    -unlimited, unlimited, "");
  }

  bool is_host_, watches_host_ = false;
  int writes_ = 0;
  std::int64_t stale_, changed_ = 0, age_ = 0;
  std::uint64_t seen_ = 0, changes_ = 0;
  Segment segment_;
  Channels channels_;
  std::vector<double> safe_, last_;
};

constexpr stepwire_known_setting settings[] = {
    {"name", "name of the shared memory, as below /dev/shm", nullptr},
    {"role", "client: joins, and has the channels of the host; host: creates it", "client"},
    {"inputs", "of a host: names with units of what the client writes: current in A, b", ""},
    {"outputs", "of a host: names with units of what the client reads", ""},
    {"stale", "age from which values are stale", "100 ms"},
    {nullptr, nullptr, nullptr}};

}  // namespace

extern "C" const stepwire_driver* stepwire_driver_v1(void) {
  static const stepwire_driver driver = stepwire::support::driver_table<SharedDevice>(
      "shared", "shared memory with a process of this machine, such as a rig in software", settings);
  return &driver;
}
