#pragma once

#include <linux/input.h>

#include <cerrno>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// Input device of the fake system, as a test sees it. Its queue is that of the kernel: readers see whole
/// reports only, and where it is full all that was not read is replaced by SYN_DROPPED and the newest event.
struct FakeInput {
  std::string path, name;
  std::map<int, input_absinfo> axes;
  std::set<int> keys, down;
  bool closed = false, unplugged = false;
  int opened = 0;
  std::deque<input_event> queue;
  std::size_t capacity = 64;

  void axis(int code, int least, int most, int flat = 0, int resolution = 0, int value = 0) {
    axes[code] = {value, least, most, 0, flat, resolution};
  }
  void send(int type, int code, int value) {
    if (type == EV_ABS) axes[code].value = value;
    if (type == EV_KEY && value != 0) down.insert(code);
    if (type == EV_KEY && value == 0) down.erase(code);
    if (queue.size() == capacity) {
      queue.clear();
      push(EV_SYN, SYN_DROPPED, 0);
    }
    push(type, code, value);
  }
  void report() { send(EV_SYN, SYN_REPORT, 0); }

 private:
  void push(int type, int code, int value) {
    input_event event{};
    event.type = static_cast<unsigned short>(type);
    event.code = static_cast<unsigned short>(code);
    event.value = value;
    queue.push_back(event);
  }
};

using FakeInputs = std::vector<FakeInput>;

/// Gamepad whose events are in a file, for other processes; the file is named by the variable FAKE_PAD.
class FakePadFile {
 public:
  explicit FakePadFile(std::string path) : path_(std::move(path)) {
    std::ofstream(path_, std::ios::binary).flush();
    ::setenv("FAKE_PAD", path_.c_str(), 1);
  }
  ~FakePadFile() { ::unsetenv("FAKE_PAD"); }
  FakePadFile(const FakePadFile&) = delete;
  FakePadFile& operator=(const FakePadFile&) = delete;

  /// Appends an event and the end of its report in one write.
  void send(int type, int code, int value) const {
    input_event events[2]{};
    events[0].type = static_cast<unsigned short>(type);
    events[0].code = static_cast<unsigned short>(code);
    events[0].value = value;
    std::ofstream file(path_, std::ios::binary | std::ios::app);
    file.write(reinterpret_cast<const char*>(events), sizeof events);
  }

 private:
  std::string path_;
};
