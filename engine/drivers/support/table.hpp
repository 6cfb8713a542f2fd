#pragma once

#include <glob.h>

#include <cstdio>
#include <exception>

#include "engine/drivers/support/settings.hpp"

namespace stepwire::support {

/// Writes the files of a pattern into a text of a size, one line each.
inline void list_files(const char* pattern, char* text, std::size_t size) {
  glob_t found{};
  std::size_t used = 0;
  if (::glob(pattern, 0, nullptr, &found) == 0)
    for (std::size_t i = 0; i < found.gl_pathc && used < size; ++i)
      used +=
          static_cast<std::size_t>(std::snprintf(text + used, size - used, "    %s\n", found.gl_pathv[i]));
  ::globfree(&found);
}

/// Functions of driver.h for a class of devices. Its constructor takes Settings and may throw; start() may
/// throw; read(), write(), safe(), stop() and report() do not. A class with wait() is a clock; one without
/// ready() has values at once.
template <class Device>
struct Calls {
  static Device& of(void* device) { return *static_cast<Device*>(device); }
  static void tell(const std::exception& problem, char* error, size_t size) {
    std::snprintf(error, size, "%s", problem.what());
  }

  static void* open(const stepwire_setting* settings, size_t count, char* error, size_t size) {
    try {
      return new Device(Settings(settings, count));
    } catch (const std::exception& problem) {
      tell(problem, error, size);
      return nullptr;
    }
  }
  static size_t channels(void* device, const stepwire_channel** table) {
    *table = of(device).channels().table().data();
    return of(device).channels().table().size();
  }
  static int start(void* device, int64_t period, const double* safe, char* error, size_t size) {
    try {
      of(device).start(period, safe);
      return 0;
    } catch (const std::exception& problem) {
      tell(problem, error, size);
      return -1;
    }
  }
  static int read(void* device, double* values) { return of(device).read(values); }
  static int write(void* device, const double* values) { return of(device).write(values); }
  static int safe(void* device) { return of(device).safe(); }
  static int wait(void* device, int64_t limit) {
    if constexpr (requires(Device & one) { one.wait(limit); }) return of(device).wait(limit);
    return -1;
  }
  static int ready(void* device) {
    if constexpr (requires(Device & one) { one.ready(); }) return of(device).ready();
    return 1;
  }
  static void stop(void* device) { of(device).stop(); }
  static void close(void* device) { delete static_cast<Device*>(device); }
  static void report(void* device, char* text, size_t size) { of(device).report(text, size); }
};

/// Returns the table of a driver; `list` may be nullptr.
template <class Device>
stepwire_driver driver_table(const char* name, const char* doc, const stepwire_known_setting* settings,
                             void (*list)(char*, size_t) = nullptr) {
  using All = Calls<Device>;
  constexpr bool is_clock = requires(Device & one) {
    one.wait(int64_t{});
  };
  return {STEPWIRE_DRIVER_VERSION,
          name,
          doc,
          settings,
          All::open,
          All::channels,
          All::start,
          All::read,
          All::write,
          All::safe,
          is_clock ? All::wait : nullptr,
          All::stop,
          All::close,
          All::report,
          list,
          All::ready};
}

}  // namespace stepwire::support
