// Driver whose device fails in the function that the setting `fails` names, in the way that `how` names. The
// environment variable BROKEN_DRIVER has such a function of the driver itself: load or list.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "engine/drivers/support/table.hpp"

namespace {

using stepwire::support::Channels;
using stepwire::support::Settings;

class BrokenDevice {
 public:
  explicit BrokenDevice(const Settings& settings)
      : fails_(settings.text("fails", "")),
        when_(settings.text("when", "")),
        how_(settings.word("how", {"error", "crash", "exit", "hang"})),
        slow_(settings.time("slow", 0.0)) {
    channels_.add("value", STEPWIRE_OUTPUT, "number", "A", -1.0, 1.0, "");
    if (settings.has("file")) lock(settings.text("file"));
    if (fails("open")) throw std::runtime_error("");
    note("open", ::getpid());
  }
  ~BrokenDevice() {
    fails("close");
    if (file_ >= 0) ::close(file_);
  }
  const Channels& channels() const {
    fails("channels");
    return channels_;
  }
  void start(std::int64_t, const double* safe) {
    safe_ = safe[0];
    if (fails("start")) throw std::runtime_error("");
    ::usleep(static_cast<useconds_t>(slow_ / 1000));
  }
  int read(double*) const { return fails("read") ? STEPWIRE_FAILED : STEPWIRE_OK; }
  int write(const double* values) const {
    note("write", values[0]);
    return fails("write") ? STEPWIRE_FAILED : STEPWIRE_OK;
  }
  int safe() const {
    if (fails("safe")) return STEPWIRE_FAILED;
    note("safe", safe_);
    return STEPWIRE_OK;
  }
  void stop() const { fails("stop"); }
  void report(char* text, std::size_t) const { *text = 0; }

 private:
  /// Returns true where a function is to return an error; crashes, ends the process or hangs where it is to.
  bool fails(const char* function) const {
    if (fails_ != function || (!when_.empty() && ::access(when_.c_str(), F_OK) != 0)) return false;
    if (how_ == 1) ::raise(SIGSEGV);
    if (how_ == 2) std::exit(0);
    while (how_ == 3) ::pause();
    return true;
  }
  void lock(const std::string& path) {
    file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) throw std::runtime_error("the device is in use");
  }
  void note(const char* what, double value) const {
    if (file_ >= 0) ::dprintf(file_, "%s %.17g\n", what, value);
  }

  std::string fails_, when_;
  std::size_t how_;
  std::int64_t slow_;
  int file_ = -1;
  double safe_ = 0.0;
  Channels channels_;
};

bool driver_fails(const char* function) {
  const char* const named = std::getenv("BROKEN_DRIVER");
  return named && std::string(named) == function;
}

void list(char* text, std::size_t) {
  if (driver_fails("list")) ::raise(SIGSEGV);
  *text = 0;
}

}  // namespace

extern "C" const stepwire_driver* stepwire_driver_v1(void) {
  static const stepwire_known_setting settings[] = {
      {"fails", "open, channels, start, read, write, safe, stop or close", ""},
      {"how", "error, crash, exit or hang", "error"},
      {"when", "file with which it fails", ""},
      {"file", "file that gets what is written, which one device at a time has open", ""},
      {"slow", "time of the start", "0 s"},
      {nullptr, nullptr, nullptr}};
  static const stepwire_driver driver =
      stepwire::support::driver_table<BrokenDevice>("broken", "a device that fails", settings, list);
  if (driver_fails("load")) std::exit(0);
  return &driver;
}
