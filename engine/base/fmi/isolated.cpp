#include "engine/base/fmi/isolated.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <new>

#include "engine/base/fmi/turns.hpp"
#include "engine/base/fmi/unit_error.hpp"

namespace stepwire::fmi {

namespace {

constexpr std::uint32_t ours = 0, of_unit = 1;
constexpr int patience = 50;  // waits of 20 ms for a process that is to end

}  // namespace

Isolated::Isolated(const Setup& setup, const Counts& counts)
    : setup_(setup), bytes_(Exchange::bytes(counts)) {
  void* memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw UnitError("the system gives no memory to share with its process");
  exchange_ = new (memory) Exchange;
  exchange_->counts = counts;
  const pid_t parent = getpid();
  process_.emplace([this, parent] { live(parent); }, std::vector<int>{});
  if (process_->started()) return;
  munmap(memory, bytes_);
  throw UnitError("the system gives no process for it");
}

Isolated::~Isolated() {
  if (!process_->has_ended()) quit();
  munmap(exchange_, bytes_);
}

/// A unit that does not end within a second is ended.
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

/// What the process does, until it is to end or the one that made it has.
void Isolated::live(pid_t parent) {
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
}

bool Isolated::run(Operation operation) {
  exchange_->operation = operation;
  bool ended = process_->ended();
  if (!ended) pass_turn(exchange_->turn, exchange_->sleepers, of_unit);
  while (!ended && !await_turn(exchange_->turn, exchange_->sleepers, ours)) ended = process_->has_ended();
  if (!ended) return exchange_->ok != 0;
  exchange_->ok = 0;
  const std::string text = fmt::format("its process {}", process_->ending());
  std::memcpy(exchange_->message, text.c_str(), std::min(text.size() + 1, sizeof exchange_->message));
  return false;
}

}  // namespace stepwire::fmi
