#pragma once

#include <sys/types.h>

#include <string>

namespace stepwire::io {

/// Registration of a temporary file or folder that is removed even if a signal ends this process.
class Leftover {
 public:
  explicit Leftover(const std::string& path, bool folder = false);
  ~Leftover();
  Leftover(const Leftover&) = delete;
  Leftover& operator=(const Leftover&) = delete;

 private:
  int place_ = -1;
};

/// Registers a process group to be killed if a signal ends this process; forget_group() undoes it.
void note_group(pid_t group);
void forget_group(pid_t group);

/// Removes all registered files and kills all registered groups. Async-signal-safe.
void remove_leftovers() noexcept;

}  // namespace stepwire::io
