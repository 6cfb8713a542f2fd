#include "engine/simulate/guard/survey.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>

#include "engine/base/io/descriptor.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/messages/bytes.hpp"
#include "engine/simulate/guard/device_bytes.hpp"
#include "engine/simulate/guard/link.hpp"

namespace stepwire::guard {

namespace {

using messages::all;
using messages::list;

/// Call of a driver in which the process of a survey is.
enum class Step : std::uint32_t { none, load, list, open, close, done };

/// Begin of the memory of a survey; the call follows, and later its answers in place of that.
struct Progress {
  std::uint32_t device = 0;
  Step step = Step::none;
};

template <class Stream>
void channels_through(Stream& stream, std::vector<SurveyedChannel>& channels) {
  list(stream, channels, [&](SurveyedChannel& one) { all(stream, one.name, one.unit, one.least, one.most); });
}

template <class Stream>
void setting_through(Stream& stream, KnownSetting& one) {
  bool has_default = one.otherwise.has_value();
  std::string otherwise = one.otherwise.value_or("");
  all(stream, one.key, one.doc, has_default, otherwise);
  one.otherwise = has_default ? std::optional(otherwise) : std::nullopt;
}

template <class Stream>
void answers_through(Stream& stream, std::vector<SurveyedDevice>& devices) {
  list(stream, devices, [&](SurveyedDevice& one) {
    all(stream, one.driver, one.doc, one.is_clock, one.plugged_in, one.failure);
    list(stream, one.settings, [&](KnownSetting& setting) { setting_through(stream, setting); });
    channels_through(stream, one.inputs);
    channels_through(stream, one.outputs);
  });
}

template <class Stream>
void call_through(Stream& stream, std::vector<DeviceSettings>& devices, SurveyDepth& depth) {
  devices_through(stream, devices);
  all(stream, depth);
}

std::string content_of(int memory) {
  struct stat status {};
  if (::fstat(memory, &status) != 0 || status.st_size < static_cast<off_t>(sizeof(Progress))) return "";
  std::string bytes(static_cast<std::size_t>(status.st_size) - sizeof(Progress), '\0');
  const ssize_t got = ::pread(memory, bytes.data(), bytes.size(), sizeof(Progress));
  bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(0, got)));
  return bytes;
}

/// Replaces the bytes after the progress.
void put_content(int memory, const std::string& bytes) {
  const bool is_put =
      ::ftruncate(memory, sizeof(Progress)) == 0 &&
      ::pwrite(memory, bytes.data(), bytes.size(), sizeof(Progress)) == static_cast<ssize_t>(bytes.size());
  if (!is_put) throw io::EnvironmentError("memory for a survey of drivers is refused");
}

void put_progress(int memory, Progress progress) {
  if (::pwrite(memory, &progress, sizeof progress, 0) != sizeof progress)
    throw io::EnvironmentError("memory for a survey of drivers is refused");
}

/// One device in the process of a survey.
class Look {
 public:
  Look(int memory, std::size_t place) : memory_(memory), place_(static_cast<std::uint32_t>(place)) {}

  SurveyedDevice at(const DeviceSettings& device, SurveyDepth depth) const {
    SurveyedDevice answer;
    try {
      begin(Step::load);
      const stepwire_driver& driver = driver::load_driver(device.file);
      describe(driver, answer);
      if (depth == SurveyDepth::list) list_plugged_in(driver, answer);
      if (depth == SurveyDepth::open) open(driver, device, answer);
    } catch (const std::exception& error) {
      answer.failure = error.what();
    }
    return answer;
  }

 private:
  void begin(Step step) const { put_progress(memory_, {place_, step}); }

  static void describe(const stepwire_driver& driver, SurveyedDevice& answer) {
    answer.driver = driver.name;
    answer.doc = driver.doc;
    answer.is_clock = driver.wait != nullptr;
    for (const stepwire_known_setting* one = driver.settings; one->key; ++one) {
      KnownSetting& setting = answer.settings.emplace_back(KnownSetting{one->key, one->doc});
      if (one->otherwise) setting.otherwise = one->otherwise;
    }
  }
  void list_plugged_in(const stepwire_driver& driver, SurveyedDevice& answer) const {
    std::array<char, 4096> text{};
    begin(Step::list);
    if (driver.list) driver.list(text.data(), text.size());
    answer.plugged_in = std::string(text.data(), ::strnlen(text.data(), text.size()));
  }
  void open(const stepwire_driver& driver, const DeviceSettings& device, SurveyedDevice& answer) const {
    begin(Step::open);
    const driver::OpenDevice open(driver, device.settings);
    for (const stepwire_channel& one : open.inputs())
      answer.inputs.push_back({one.name, one.unit, one.least, one.most});
    for (const stepwire_channel& one : open.outputs())
      answer.outputs.push_back({one.name, one.unit, one.least, one.most});
    begin(Step::close);
  }

  int memory_;
  std::uint32_t place_;
};

/// Becomes the process of a survey, which ends with this one, in a session of its own that a terminal's
/// signals do not reach.
[[noreturn]] void become_survey(const std::string& program, int memory) {
  constexpr int first = 3;
  ::setsid();
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int moved = ::fcntl(memory, F_DUPFD, first + 1);
  ::dup2(moved, first);
  ::close_range(first + 1, ~0u, 0);
  ::execl(program.c_str(), "stepwire_guard", "3", nullptr);
  ::_exit(127);
}

const char* words_of(Step step) {
  constexpr std::array<const char*, 5> words{"", "while it was loaded", "in list", "in open or channels",
                                             "in close"};
  return words[static_cast<std::size_t>(step)];
}

/// Process of a survey, as its caller sees it.
class SurveyProcess {
 public:
  SurveyProcess(const std::vector<DeviceSettings>& devices, SurveyDepth depth)
      : devices_(devices), memory_(::memfd_create("stepwire-survey", MFD_CLOEXEC)) {
    const std::string program = driver::program_file("stepwire_guard");
    messages::ByteWriter call;
    std::vector<DeviceSettings> all = devices;
    call_through(call, all, depth);
    put_progress(memory_.number(), {});
    put_content(memory_.number(), call.take());
    process_ = ::fork();
    if (process_ == 0) become_survey(program, memory_.number());
    if (process_ < 0)
      throw io::EnvironmentError(fmt::format("no process for drivers starts: {}", std::strerror(errno)));
  }
  ~SurveyProcess() {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  SurveyProcess(const SurveyProcess&) = delete;
  SurveyProcess& operator=(const SurveyProcess&) = delete;

  /// Waits for its end, at most `limit` [ns]. Returns false once `interrupt` is true.
  bool await(std::int64_t limit, const std::atomic<bool>* interrupt) {
    const std::int64_t end = monotonic() + limit;
    while (!has_ended() && monotonic() < end) {
      if (interrupt && *interrupt) return false;
      ::usleep(500);
    }
    return true;
  }
  std::vector<SurveyedDevice> answers(std::int64_t limit) {
    Progress progress;
    if (::pread(memory_.number(), &progress, sizeof progress, 0) != sizeof progress) progress = {};
    std::vector<SurveyedDevice> all;
    const std::string bytes = content_of(memory_.number());
    messages::ByteReader reader(bytes);
    if (progress.step == Step::done) answers_through(reader, all);
    if (progress.step == Step::done && reader.whole() && all.size() == devices_.size()) return all;
    if (progress.step == Step::none || progress.step >= Step::done || progress.device >= devices_.size())
      throw io::EnvironmentError("no driver was called: the process for drivers " + end_text(limit));
    all.assign(devices_.size(), {});
    const bool is_slow = change_.si_pid == 0 && progress.step == Step::open;
    all[progress.device].failure = fmt::format(
        "the driver {} {} {}{}", devices_[progress.device].driver, end_text(limit), words_of(progress.step),
        is_slow ? "; a larger 'wait' of the rig lets it take longer" : "");
    return all;
  }

 private:
  bool has_ended() {
    return ::waitid(P_PID, static_cast<id_t>(process_), &change_, WEXITED | WNOHANG | WNOWAIT) != 0 ||
           change_.si_pid != 0;
  }
  std::string end_text(std::int64_t limit) const {
    if (change_.si_pid == 0)
      return fmt::format("has not returned within {:.3g} s", 1e-9 * static_cast<double>(limit));
    if (change_.si_code == CLD_EXITED)
      return fmt::format("has ended its process with exit code {}", change_.si_status);
    return fmt::format("was ended by signal {} ({})", change_.si_status, ::strsignal(change_.si_status));
  }

  const std::vector<DeviceSettings>& devices_;
  io::Descriptor memory_;
  pid_t process_ = -1;
  siginfo_t change_{};
};

}  // namespace

std::optional<std::vector<SurveyedDevice>> survey(const std::vector<DeviceSettings>& devices,
                                                  SurveyDepth depth, std::int64_t limit,
                                                  const std::atomic<bool>* interrupt) {
  if (devices.empty()) return std::vector<SurveyedDevice>{};
  SurveyProcess process(devices, depth);
  if (!process.await(limit, interrupt)) return std::nullopt;
  return process.answers(limit);
}

int run_survey(int memory) {
  try {
    std::vector<DeviceSettings> devices;
    SurveyDepth depth = SurveyDepth::load;
    const std::string call = content_of(memory);
    messages::ByteReader reader(call);
    call_through(reader, devices, depth);
    std::vector<SurveyedDevice> answers;
    for (std::size_t i = 0; i < devices.size(); ++i) answers.push_back(Look(memory, i).at(devices[i], depth));
    messages::ByteWriter writer;
    answers_through(writer, answers);
    put_content(memory, writer.take());
    put_progress(memory, {0, Step::done});
    ::_exit(0);  // functions of drivers at the exit are not called
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}

}  // namespace stepwire::guard
