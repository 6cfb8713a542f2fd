#pragma once

#include <sys/types.h>

#include <string>

namespace stepwire::io {

/// A temporary file, or a folder with all that is in it, that goes, too, where a signal ends this process at
/// once.
class Leftover {
 public:
  explicit Leftover(const std::string& path, bool folder = false);
  ~Leftover();
  Leftover(const Leftover&) = delete;
  Leftover& operator=(const Leftover&) = delete;

 private:
  int place_ = -1;
};

/// Process groups that end where a signal ends this process at once.
void note_group(pid_t group);
void forget_group(pid_t group);

/// Removes the files and ends the groups that are noted now. A signal handler may call it.
void remove_leftovers() noexcept;

}  // namespace stepwire::io
