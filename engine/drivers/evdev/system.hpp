#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace stepwire::evdev {

/// Calls of the system that the drivers of input devices make. Tests link others in their place.
struct System {
  /// Returns the files of all input devices, in the order of their numbers.
  static std::vector<std::string> files();
  /// Opens a file for reading without waiting. Returns -1 with errno.
  static int open(const char* path);
  static void close(int file);
  /// Reads whole events. Returns -1 with errno EAGAIN where there is none, ENODEV once the device is
  /// unplugged.
  static ssize_t read(int file, void* events, std::size_t bytes);
  /// Returns a negative number with errno where a request fails.
  static int request(int file, unsigned long code, void* data);
};

}  // namespace stepwire::evdev
