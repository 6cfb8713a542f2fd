#include "engine/drivers/evdev/input_file.hpp"

#include <cerrno>
#include <utility>

#include "engine/drivers/evdev/system.hpp"

namespace stepwire::evdev {

std::optional<InputFile> InputFile::open(const std::string& path) {
  const int file = System::open(path.c_str());
  if (file < 0) return std::nullopt;
  InputFile opened(path, file);
  if (opened.describe()) return opened;
  errno = ENOTTY;  // as of requests to other files
  return std::nullopt;
}

InputFile::InputFile(InputFile&& other) noexcept
    : path_(std::move(other.path_)),
      name_(std::move(other.name_)),
      file_(std::exchange(other.file_, -1)),
      keys_(other.keys_),
      axes_(other.axes_) {}

InputFile::~InputFile() {
  if (file_ >= 0) System::close(file_);
}

bool InputFile::describe() {
  std::array<char, 256> name{};
  if (System::request(file_, EVIOCGNAME(name.size() - 1), name.data()) < 0) return false;
  name_ = name.data();
  return System::request(file_, EVIOCGBIT(EV_ABS, Axes::bytes()), axes_.data()) >= 0 &&
         System::request(file_, EVIOCGBIT(EV_KEY, Keys::bytes()), keys_.data()) >= 0;
}

bool InputFile::fetch(std::size_t axis, input_absinfo& info) const noexcept {
  return System::request(file_, EVIOCGABS(axis), &info) >= 0;
}

bool InputFile::fetch(Keys& down) const noexcept {
  return System::request(file_, EVIOCGKEY(Keys::bytes()), down.data()) >= 0;
}

std::optional<std::size_t> InputFile::read(input_event* events, std::size_t count) const noexcept {
  const ssize_t bytes = System::read(file_, events, count * sizeof(input_event));
  if (bytes > 0) return static_cast<std::size_t>(bytes) / sizeof(input_event);
  if (bytes < 0 && (errno == EAGAIN || errno == EINTR)) return 0;
  return std::nullopt;
}

}  // namespace stepwire::evdev
