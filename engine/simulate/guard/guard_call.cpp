#include "engine/simulate/guard/guard_call.hpp"

#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>

#include <exception>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/messages/bytes.hpp"
#include "engine/simulate/guard/device_bytes.hpp"

namespace stepwire::guard {

namespace {

using messages::all;
using messages::list;

template <class Stream>
void limits_through(Stream& stream, WatchLimits& of) {
  all(stream, of.period, of.late, of.ramp);
  list(stream, of.devices, [&](std::string& one) { all(stream, one); });
  list(stream, of.inputs,
       [&](InputLimits& one) { all(stream, one.name, one.unit, one.least, one.most, one.rate, one.stuck); });
  list(stream, of.outputs,
       [&](OutputLimits& one) { all(stream, one.name, one.unit, one.safe, one.least, one.most, one.rate); });
  std::vector<DeadMan> men;
  if (of.dead_man) men.push_back(*of.dead_man);
  list(stream, men, [&](DeadMan& one) { all(stream, one.input, one.above); });
  if (!men.empty()) of.dead_man = men.front();
  list(stream, of.powers,
       [&](PowerLimit& one) { all(stream, one.name, one.effort, one.flow, one.flow_is_position, one.most); });
}

template <class Stream>
void through(Stream& stream, GuardCall& call) {
  devices_through(stream, call.devices);
  messages::plain_list(stream, call.uses);
  limits_through(stream, call.limits);
  all(stream, call.wait, call.priority);
}

}  // namespace

std::string bytes_of(GuardCall call) {
  messages::ByteWriter writer;
  through(writer, call);
  return writer.take();
}

namespace {

void set_safe(const DeviceSettings& one, std::int64_t period, const double* safe, const BeforeCall& before) {
  const auto begin = [&](const char* function) {
    if (before) before(one.name, function);
  };
  begin("open");
  driver::OpenDevice device(driver::load_driver(one.file), one.settings);
  begin("start");
  device.start(period, safe);
  begin("safe");
  if (one.outputs > 0 && device.safe() == STEPWIRE_FAILED)
    throw io::EnvironmentError("the device does not take its safe values");
  begin("stop");
  device.stop();
  begin("close");
}

}  // namespace

std::string set_safe(const GuardCall& call, const BeforeCall& before) noexcept {
  std::string failures;
  const Watch watch(call.limits);
  const double* safe = watch.safe();
  for (const DeviceSettings& one : call.devices) {
    try {
      set_safe(one, call.limits.period, safe, before);
    } catch (const std::exception& error) {
      failures += (failures.empty() ? "" : "; ") + one.name + ": " + error.what();
    }
    safe += one.outputs;
  }
  return failures;
}

void become_prompt(int priority) {
  ::mlockall(MCL_CURRENT | MCL_FUTURE);
  ::prctl(PR_SET_TIMERSLACK, 1);
  sched_param parameter{};
  parameter.sched_priority = priority;
  if (priority > 0) ::sched_setscheduler(0, SCHED_FIFO, &parameter);
}

GuardCall guard_call(std::string_view bytes) {
  messages::ByteReader reader(bytes);
  GuardCall call;
  through(reader, call);
  if (!reader.whole() || !reader.at_end() || call.uses.size() != call.devices.size())
    throw io::EnvironmentError("the call of the guard is not whole");
  return call;
}

}  // namespace stepwire::guard
