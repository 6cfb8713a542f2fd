#include "engine/drivers/evdev/system.hpp"

#include <fcntl.h>
#include <glob.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

namespace stepwire::evdev {

std::vector<std::string> System::files() {
  std::vector<std::string> found;
  glob_t paths{};
  if (::glob("/dev/input/event*", 0, nullptr, &paths) == 0)
    found.assign(paths.gl_pathv, paths.gl_pathv + paths.gl_pathc);
  ::globfree(&paths);
  std::stable_sort(found.begin(), found.end(), [](const std::string& a, const std::string& b) {
    return a.size() < b.size();  // event2 before event10
  });
  return found;
}

int System::open(const char* path) {
  return ::open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
}

void System::close(int file) {
  ::close(file);
}

ssize_t System::read(int file, void* events, std::size_t bytes) {
  return ::read(file, events, bytes);
}

int System::request(int file, unsigned long code, void* data) {
  return ::ioctl(file, code, data);
}

}  // namespace stepwire::evdev
