#include "engine/base/fmi/isolated.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <new>

#include "engine/base/fmi/turns.hpp"
#include "engine/base/fmi/unit_error.hpp"

namespace stepwire::fmi {

namespace {

constexpr std::uint32_t ours = 0, of_unit = 1;
constexpr int patience = 50;  // waits of 20 ms for a process that is to end

/// A process of its own has the signals' usual meaning, but is not interrupted from the terminal: whoever
/// runs it is, and ends it. Files and sockets of the other one are not for foreign code.
void leave_other_process() {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGPIPE})
    std::signal(signal, SIG_DFL);
  for (const int signal : {SIGINT, SIGHUP, SIGQUIT}) std::signal(signal, SIG_IGN);
  close_range(3, ~0u, 0);
}

std::string ending_of(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("its process was ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return fmt::format("its process has ended itself with status {}", WEXITSTATUS(status));
}

}  // namespace

Isolated::Isolated(const Setup& setup, const Counts& counts) : setup_(setup), bytes_(Exchange::bytes(counts)) {
  void* memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw UnitError("the system gives no memory to share with its process");
  exchange_ = new (memory) Exchange;
  exchange_->counts = counts;
  const pid_t parent = getpid();
  child_ = fork();
  if (child_ == 0) live(parent);
  if (child_ > 0) return;
  munmap(memory, bytes_);
  throw UnitError("the system gives no process for it");
}

Isolated::~Isolated() {
  if (!ended_) {
    exchange_->operation = Operation::quit;
    pass_turn(exchange_->turn, exchange_->sleepers, of_unit);
    bool freed = false;
    for (int i = 0; i < patience && !freed && !has_ended(); ++i)
      freed = await_turn(exchange_->turn, exchange_->sleepers, ours);
    if (!ended_ && !freed) kill(child_, SIGKILL);
    if (!ended_) waitpid(child_, &status_, 0);
  }
  munmap(exchange_, bytes_);
}

/// What the process does, until it is to end or the one that made it has.
void Isolated::live(pid_t parent) {
  leave_other_process();
  {
    Model model(setup_, *exchange_);
    while (getppid() == parent) {
      if (!await_turn(exchange_->turn, exchange_->sleepers, of_unit)) continue;
      if (exchange_->operation == Operation::quit) break;
      model.run();
      pass_turn(exchange_->turn, exchange_->sleepers, ours);
    }
  }
  pass_turn(exchange_->turn, exchange_->sleepers, ours);
  _exit(0);
}

bool Isolated::has_ended() {
  if (!ended_) ended_ = waitpid(child_, &status_, WNOHANG) == child_;
  return ended_;
}

bool Isolated::run(Operation operation) {
  exchange_->operation = operation;
  if (!ended_) pass_turn(exchange_->turn, exchange_->sleepers, of_unit);
  while (!ended_ && !await_turn(exchange_->turn, exchange_->sleepers, ours)) has_ended();
  if (!ended_) return exchange_->ok != 0;
  exchange_->ok = 0;
  const std::string text = ending_of(status_);
  std::memcpy(exchange_->message, text.c_str(), std::min(text.size() + 1, sizeof exchange_->message));
  return false;
}

}  // namespace stepwire::fmi
