// Calls of the system for the drivers of input devices under test, answered as by the event interface of the
// kernel from devices in memory. Where the environment variable FAKE_PAD names a file, a gamepad in its place
// has the events that a test appends there, so that other processes see them, too.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "engine/drivers/evdev/system.hpp"
#include "tests/support/evdev/fake_input.hpp"

namespace {

FakeInputs inputs;
int pad_file = -1;

/// Returns the devices; the gamepad of FAKE_PAD is added at the first call.
FakeInputs& devices() {
  const char* const path = std::getenv("FAKE_PAD");
  if (!path || !inputs.empty()) return inputs;
  FakeInput& pad = inputs.emplace_back();
  pad.path = path;
  pad.name = "Pad";
  for (const int code : {ABS_X, ABS_Y}) pad.axis(code, -32768, 32767, 128);
  pad.keys = {BTN_SOUTH, BTN_TL};
  return inputs;
}

/// Adds the events of the file that are new.
void take_new_events(FakeInput& pad) {
  const char* const path = std::getenv("FAKE_PAD");
  if (!path) return;
  if (pad_file < 0) pad_file = ::open(path, O_RDONLY | O_CLOEXEC);
  input_event event{};
  while (::read(pad_file, &event, sizeof event) == static_cast<ssize_t>(sizeof event))
    pad.send(event.type, event.code, event.value);
}

int fail(int reason) {
  errno = reason;
  return -1;
}

/// Writes a set of bits as the kernel does, at most `size` bytes of it.
template <class Set>
int put_bits(const Set& set, void* data, std::size_t size) {
  auto* const bytes = static_cast<unsigned char*>(data);
  std::memset(bytes, 0, size);
  for (const int code : set)
    if (const auto at = static_cast<std::size_t>(code) / 8; at < size)
      bytes[at] = static_cast<unsigned char>(bytes[at] | 1u << code % 8);
  return static_cast<int>(size);
}

std::set<int> codes_of(const std::map<int, input_absinfo>& axes) {
  std::set<int> codes;
  for (const auto& [code, info] : axes) codes.insert(code);
  return codes;
}

}  // namespace

extern "C" FakeInputs* fake_inputs() {
  return &inputs;
}

namespace stepwire::evdev {

std::vector<std::string> System::files() {
  std::vector<std::string> paths;
  for (const FakeInput& one : devices()) paths.push_back(one.path);
  return paths;
}

int System::open(const char* path) {
  devices();
  const auto found =
      std::find_if(inputs.begin(), inputs.end(), [path](const FakeInput& one) { return one.path == path; });
  if (found == inputs.end()) return fail(ENOENT);
  if (found->closed) return fail(EACCES);
  ++found->opened;
  return static_cast<int>(found - inputs.begin());
}

void System::close(int file) {
  --inputs.at(static_cast<std::size_t>(file)).opened;
}

ssize_t System::read(int file, void* events, std::size_t bytes) {
  FakeInput& one = inputs.at(static_cast<std::size_t>(file));
  take_new_events(one);
  if (one.unplugged) return fail(ENODEV);
  const auto is_end = [](const input_event& event) {
    return event.type == EV_SYN && event.code == SYN_REPORT;
  };
  const auto end = std::find_if(one.queue.rbegin(), one.queue.rend(), is_end).base();
  const auto whole = static_cast<std::size_t>(end - one.queue.begin());
  const std::size_t count = std::min(whole, bytes / sizeof(input_event));
  if (count == 0) return fail(EAGAIN);
  std::copy_n(one.queue.begin(), count, static_cast<input_event*>(events));
  one.queue.erase(one.queue.begin(), one.queue.begin() + static_cast<std::ptrdiff_t>(count));
  return static_cast<ssize_t>(count * sizeof(input_event));
}

/// Answers the requests of the letter 'E' by their numbers: 06 name, 18 buttons that are down, 20 + type
/// codes of a type, 40 + axis range of an axis.
int System::request(int file, unsigned long code, void* data) {
  FakeInput& one = inputs.at(static_cast<std::size_t>(file));
  if (one.unplugged) return fail(ENODEV);
  const unsigned long letter = code >> 8 & 0xff, number = code & 0xff, size = code >> 16 & 0x3fff;
  if (letter != 'E') return fail(EINVAL);
  if (number == 0x06) {
    std::strncpy(static_cast<char*>(data), one.name.c_str(), size);
    return static_cast<int>(std::min<std::size_t>(size, one.name.size() + 1));
  }
  if (number == 0x18) return put_bits(one.down, data, size);
  if (number == 0x21) return put_bits(one.keys, data, size);
  if (number == 0x23) return put_bits(codes_of(one.axes), data, size);
  const auto axis = one.axes.find(static_cast<int>(number) - 0x40);
  if (axis == one.axes.end() || size != sizeof(input_absinfo)) return fail(EINVAL);
  std::memcpy(data, &axis->second, size);
  return 0;
}

}  // namespace stepwire::evdev
