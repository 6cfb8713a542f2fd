#include "engine/base/fmi/runner.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/futex.h>
#include <stdio_ext.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <list>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "engine/base/fmi/foreign_call.hpp"
#include "engine/base/fmi/unit_error.hpp"
#include "engine/base/io/descriptor.hpp"
#include "engine/base/io/leftovers.hpp"
#include "engine/base/subprocess/fork.hpp"
#include "engine/base/subprocess/process.hpp"

namespace stepwire::fmi {
namespace {

/// A unit in a process of its own. Both processes have the exchange in shared memory and take turns. An
/// operation ends that process if it exceeds the time limit of helper programs, or lasts a second after an
/// interruption.
class Isolated : public Runner {
 public:
  Isolated(const Setup& setup, const Counts& counts);
  ~Isolated() override;
  Isolated(const Isolated&) = delete;
  Isolated& operator=(const Isolated&) = delete;

  bool run(Operation operation) override;

 private:
  void live();
  void quit();
  /// Kills the process; the operation fails with this reason.
  bool end(const char* why);
  bool fail(const std::string& why);

  Setup setup_;
  std::size_t bytes_;
  long limit_;  ///< of one operation, in waits
  std::optional<subprocess::Fork> process_;
};

// Number of polls before sleeping: at most 5 us, about the time of waking a process. Where all processors are
// busy, the other process begins when this one sleeps.
constexpr int looks = 150;

void rest() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

static_assert(sizeof(std::atomic<std::uint32_t>) == 4 && std::atomic<std::uint32_t>::is_always_lock_free);

void sleep_while(std::atomic<std::uint32_t>& turn, std::uint32_t value) {
  const timespec most{0, 20'000'000};
  syscall(SYS_futex, reinterpret_cast<std::uint32_t*>(&turn), FUTEX_WAIT, value, &most, nullptr, 0);
}

/// Passes the turn to the other process and wakes it if it sleeps.
void pass_turn(std::atomic<std::uint32_t>& turn, std::atomic<std::uint32_t>& sleepers, std::uint32_t to) {
  turn.store(to);
  if (sleepers.load() > 0)
    syscall(SYS_futex, reinterpret_cast<std::uint32_t*>(&turn), FUTEX_WAKE, 1, nullptr, nullptr, 0);
}

/// Waits for this turn, first by polling, then asleep. Returns false after 20 ms.
bool await_turn(std::atomic<std::uint32_t>& turn, std::atomic<std::uint32_t>& sleepers, std::uint32_t own) {
  for (int i = 0; i < looks; ++i) {
    if (turn.load(std::memory_order_acquire) == own) return true;
    rest();
  }
  sleepers.fetch_add(1);
  const std::uint32_t seen = turn.load();
  if (seen != own) sleep_while(turn, seen);
  sleepers.fetch_sub(1);
  return turn.load() == own;
}

constexpr std::uint32_t ours = 0, of_unit = 1;
constexpr int patience = 50;                   // waits granted to an ending process or an interrupted call
constexpr std::chrono::milliseconds wait{20};  // longest time of one await_turn()

/// Returns the time limit as a number of waits. A clock would keep running while both processes are stopped.
long waits_of_limit() {
  return static_cast<long>(subprocess::usual_limit() / wait) + 1;
}

Isolated::Isolated(const Setup& setup, const Counts& counts)
    : setup_(setup), bytes_(Exchange::bytes(counts)), limit_(waits_of_limit()) {
  void* memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw UnitError("the system gives no memory to share with its process");
  exchange_ = new (memory) Exchange;
  exchange_->counts = counts;
  process_.emplace([this] { live(); }, std::vector<int>{});
  if (process_->started()) return;
  munmap(memory, bytes_);
  throw UnitError("the system gives no process for it");
}

Isolated::~Isolated() {
  if (!process_->has_ended()) quit();
  munmap(exchange_, bytes_);
}

/// Sends the operation `quit`; kills the process of the unit after one second.
void Isolated::quit() {
  exchange_->operation = Operation::quit;
  pass_turn(exchange_->turn, exchange_->sleepers, of_unit);
  bool freed = false;
  for (int i = 0; i < patience && !freed && !process_->has_ended(); ++i)
    freed = await_turn(exchange_->turn, exchange_->sleepers, ours);
  if (freed)
    process_->wait();
  else
    process_->end();
}

/// Serves operations in the child process until `quit`. The process ends with its parent.
void Isolated::live() {
  // Prints of the unit are redirected to standard error, since standard output may be a table.
  __fpurge(stdout);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  {
    Model model(setup_, *exchange_);
    while (true) {
      if (!await_turn(exchange_->turn, exchange_->sleepers, of_unit)) continue;
      if (exchange_->operation == Operation::quit) break;
      model.run();
      pass_turn(exchange_->turn, exchange_->sleepers, ours);
    }
  }
  pass_turn(exchange_->turn, exchange_->sleepers, ours);
}

bool Isolated::run(Operation operation) {
  exchange_->operation = operation;
  if (process_->ended()) return fail(process_->ending());
  pass_turn(exchange_->turn, exchange_->sleepers, of_unit);
  long interrupted = 0;
  for (long waits = 0; !await_turn(exchange_->turn, exchange_->sleepers, ours); ++waits) {
    if (process_->has_ended()) return fail(process_->ending());
    interrupted = subprocess::processes_stop() ? interrupted + 1 : 0;
    if (interrupted > patience) return end("was ended by an interruption");
    if (waits > limit_)
      return end("does not come to an end and was ended; STEPWIRE_HELPER_LIMIT allows more seconds");
  }
  return exchange_->ok != 0;
}

bool Isolated::end(const char* why) {
  process_->end();
  return fail(why);
}

bool Isolated::fail(const std::string& why) {
  exchange_->ok = 0;
  const bool known = exchange_->call.under_way();
  const std::string text =
      fmt::format("its process {}{}", known ? "in " + exchange_->call.text() + " " : "", why);
  std::memcpy(exchange_->message, text.c_str(), std::min(text.size() + 1, sizeof exchange_->message));
  return false;
}

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
