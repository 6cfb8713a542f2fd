#include "engine/base/fmi/runner.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <list>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "engine/base/fmi/foreign_call.hpp"
#include "engine/base/fmi/isolated.hpp"
#include "engine/base/io/descriptor.hpp"
#include "engine/base/io/leftovers.hpp"
#include "engine/base/subprocess/process.hpp"

namespace stepwire::fmi {

namespace {

/// Watchdog for the calls of a unit that runs in this process. It ends the process with a message that names
/// the unit and the call. The exit status is 3 where the unit calls exit() or quick_exit(), or exceeds the
/// time limit of helper programs. It is 130 where a call lasts a second after an interruption.
class CallWatch {
 public:
  /// `unit` begins the message: "wheel: the unit wheel.fmu".
  CallWatch(const CallNote& note, std::string unit);
  ~CallWatch();
  CallWatch(const CallWatch&) = delete;
  CallWatch& operator=(const CallWatch&) = delete;

 private:
  const CallNote& note_;
};

constexpr int of_surroundings = 3, of_interruption = 130;  // exit statuses
constexpr const char* cure = "; with isolate: true that ends the run with a message, and its rows are kept";
constexpr std::chrono::milliseconds between_looks(50);
constexpr long looks_of_interruption = 20;

[[noreturn]] void end_process(int status, const std::string& sentence) {
  const std::string line = sentence + cure + "\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
  io::remove_leftovers();
  ::_exit(status);
}

/// A watched unit and the number of polls since its current call began. Polls are counted instead of time,
/// since a clock keeps running while the process is stopped.
struct Watched {
  const CallNote* note;
  std::string unit;
  long limit;
  std::uint32_t call = 0;
  long looks = 0, interrupted = 0;

  void look(bool stop) {
    const std::uint32_t now = note->count.load(std::memory_order_acquire);
    const bool same = now == call && note->under_way();
    call = now;
    looks = same ? looks + 1 : 0;
    interrupted = same && stop ? interrupted + 1 : 0;
    if (looks > limit)
      end_process(of_surroundings,
                  fmt::format("{} does not come to an end in {}; STEPWIRE_HELPER_LIMIT allows more seconds",
                              unit, note->text()));
    if (interrupted > looks_of_interruption)
      end_process(of_interruption,
                  fmt::format("{} does not come to an end in {} after an interruption", unit, note->text()));
  }
};

/// Watch of all units of this process.
class Watch {
 public:
  static Watch& of_process() {
    static Watch watch;
    return watch;
  }

  void add(Watched watched) {
    const std::lock_guard lock(mutex_);
    catch_exits();
    all_.push_back(std::move(watched));
    if (all_.size() == 1) begin();
  }
  void remove(const CallNote& note) {
    std::jthread ended;  // joined after the lock is released
    const std::lock_guard lock(mutex_);
    std::erase_if(all_, [&](const Watched& watched) { return watched.note == &note; });
    if (all_.empty()) ended = std::move(thread_);
  }
  /// Reports the exit that a unit has requested, and ends the process.
  void end_exit(const std::string& how) {
    if (::getpid() != process_) return;
    const std::lock_guard lock(mutex_);
    const auto calling =
        std::ranges::find_if(all_, [](const Watched& watched) { return watched.note->under_way(); });
    if (calling != all_.end())
      end_process(of_surroundings,
                  fmt::format("{} ended the program by {} in {}", calling->unit, how, calling->note->text()));
  }

 private:
  Watch() = default;

  /// Registers the exit handlers. The constructor must not: its handlers would run after the destructor.
  void catch_exits() {
    if (std::exchange(catches_exits_, true)) return;
    ::on_exit([](int status, void*) { of_process().end_exit(fmt::format("exit({})", status)); }, nullptr);
    std::at_quick_exit([] { of_process().end_exit("quick_exit()"); });
  }

  void begin() {
    process_ = ::getpid();  // end_exit() ignores forked copies of this process
    try {
      thread_ = std::jthread([this](const std::stop_token& stop) { look(stop); });
    } catch (const std::system_error&) {  // without a thread, exits are detected and hanging calls are not
    }
  }

  void look(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      changed_.wait_for(lock, stop, between_looks, [] { return false; });
      for (Watched& watched : all_) watched.look(subprocess::processes_stop());
    }
  }

  pid_t process_ = ::getpid();
  bool catches_exits_ = false;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::list<Watched> all_;
  std::jthread thread_;
};

CallWatch::CallWatch(const CallNote& note, std::string unit) : note_(note) {
  const auto limit = static_cast<long>(subprocess::usual_limit() / between_looks) + 1;
  Watch::of_process().add({&note, std::move(unit), limit});
}

CallWatch::~CallWatch() {
  Watch::of_process().remove(note_);
}

/// Runner in this process.
class Inside : public Runner {
 public:
  Inside(const Setup& setup, const Counts& counts)
      : setup_(setup), memory_(new (std::align_val_t(alignof(Exchange))) char[Exchange::bytes(counts)]()) {
    exchange_ = new (memory_.get()) Exchange;
    exchange_->counts = counts;
    watch_.emplace(exchange_->call, fmt::format("{}: the unit {}", setup.name, setup.package->path()));
    model_ = std::make_unique<Model>(setup_, *exchange_);
  }

  bool run(Operation operation) override {
    exchange_->operation = operation;
    model_->run();
    [[maybe_unused]] const int back = ::fchdir(folder_.number());  // a unit may change the working directory
    return exchange_->ok != 0;
  }

 private:
  struct Free {
    void operator()(char* memory) const { ::operator delete[](memory, std::align_val_t(alignof(Exchange))); }
  };
  Setup setup_;
  /// Working directory, into which results are written.
  io::Descriptor folder_{::open(".", O_PATH | O_DIRECTORY | O_CLOEXEC)};
  std::unique_ptr<char[], Free> memory_;
  std::optional<CallWatch> watch_;
  std::unique_ptr<Model> model_;
};

}  // namespace

std::unique_ptr<Runner> make_runner(const Setup& setup, bool isolated, std::size_t kept) {
  Counts counts = counts_of(setup);
  counts.kept = kept;
  if (isolated) return std::make_unique<Isolated>(setup, counts);
  return std::make_unique<Inside>(setup, counts);
}

}  // namespace stepwire::fmi
