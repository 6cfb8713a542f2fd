#include "engine/base/fmi/isolated.hpp"

#include <fmt/format.h>
#include <linux/futex.h>
#include <stdio_ext.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <new>

#include "engine/base/fmi/unit_error.hpp"
#include "engine/base/subprocess/process.hpp"

namespace stepwire::fmi {

namespace {

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

}  // namespace

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

}  // namespace stepwire::fmi
