// Driver whose device fails in the way that the setting `fails` names.
#include <unistd.h>
#include <csignal>

#include "engine/drivers/support/table.hpp"

namespace {

using stepwire::support::Channels;
using stepwire::support::Settings;

class BrokenDevice {
 public:
  explicit BrokenDevice(const Settings& settings) : fails_(settings.text("fails")) {
    channels_.add("value", STEPWIRE_OUTPUT, "number", "A", -1.0, 1.0, "");
    if (fails_ == "open") throw std::runtime_error("");
  }
  const Channels& channels() const { return channels_; }
  void start(std::int64_t, const double*) const {
    if (fails_ == "crash") ::raise(SIGSEGV);
    if (fails_ == "start") throw std::runtime_error("");
  }
  int read(double*) const { return STEPWIRE_OK; }
  int write(const double*) const { return fails_ == "write" ? STEPWIRE_FAILED : STEPWIRE_OK; }
  int safe() const { return fails_ == "safe" ? STEPWIRE_FAILED : STEPWIRE_OK; }
  void stop() const {}
  void report(char* text, std::size_t) const { *text = 0; }

 private:
  std::string fails_;
  Channels channels_;
};

}  // namespace

extern "C" const stepwire_driver* stepwire_driver_v1(void) {
  static const stepwire_known_setting settings[] = {{"fails", "open, start, crash, write or safe", nullptr},
                                                    {nullptr, nullptr, nullptr}};
  static const stepwire_driver driver =
      stepwire::support::driver_table<BrokenDevice>("broken", "a device that fails", settings);
  return &driver;
}
