#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::guard {

/// Returns the time of CLOCK_MONOTONIC [ns].
std::int64_t monotonic();

/// State of a guard, as the loop sees it.
enum class GuardState : std::uint32_t {
  starting,
  running,
  tripped,  ///< the outputs are safe for good; the reason is stated
  failed,   ///< it could not start; the reason is stated
  ended
};

/// Request of a loop to its guard. `gone` comes in its place once the process of the loop has ended.
enum class GuardRequest : std::uint32_t { start, command, rest, finish, gone };

/// Values of the outputs, as the guard notes them for its keeper.
enum class Outputs : std::uint32_t {
  safe,     ///< the safe values, until the next command
  live,     ///< those of the loop
  becoming  ///< the safe values are being written
};

/// Numbers that one process writes and another one reads whole. `lock` is odd while they change. A writer
/// that ends inside leaves it odd, and the reader keeps its values.
class SharedNumbers {
 public:
  SharedNumbers(std::atomic<std::uint32_t>& lock, std::atomic<double>* values, std::size_t count)
      : lock_(lock), values_(values), count_(count) {}

  void put(const double* values) noexcept;
  /// Makes the lock odd, as put() does before the numbers change.
  void begin() noexcept;
  /// Returns false where no whole change is found within some microseconds; the values may then be torn.
  bool get(double* values) const noexcept;

 private:
  std::atomic<std::uint32_t>& lock_;
  std::atomic<double>* values_;
  std::size_t count_;
};

/// Memory that a loop and its guard share: counters, inputs, commands, and the call of the guard.
class Link {
 public:
  /// Creates it. Throws EnvironmentError.
  Link(std::size_t inputs, std::size_t outputs, std::string_view call);
  /// Maps the one of a descriptor; throws EnvironmentError.
  explicit Link(io::Descriptor memory);
  ~Link();
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  int descriptor() const { return memory_.number(); }
  /// Returns the process that has created it, which is the loop.
  int loop() const { return head_->loop; }
  std::string_view call() const;
  SharedNumbers inputs() const { return {head_->inputs_lock, numbers(), head_->inputs}; }
  SharedNumbers commands() const { return {head_->commands_lock, numbers() + head_->inputs, head_->outputs}; }

  /// Counts a command or request, and wakes the guard where it sleeps.
  void beat(GuardRequest request) noexcept;
  std::uint32_t beats() const { return head_->beats.load(std::memory_order_acquire); }
  GuardRequest request() const { return static_cast<GuardRequest>(head_->request.load()); }
  /// Sleeps until beats() differs from `seen`, or until the time [ns] of CLOCK_MONOTONIC.
  void await_beat(std::uint32_t seen, std::int64_t until) noexcept;
  /// Waits for the same without sleep, so that a beat need not wake the guard. Returns at once on the
  /// processor of the last beat, where the loop would have to wait for its guard.
  void look_for_beat(std::uint32_t seen, std::int64_t until) const noexcept;

  /// Notes the time at which the guard has read the devices [ns].
  void note_read(std::int64_t time) noexcept { head_->read_at.store(time, std::memory_order_release); }
  std::int64_t read_at() const { return head_->read_at.load(std::memory_order_acquire); }

  void note_outputs(Outputs values) noexcept {
    head_->values.store(static_cast<std::uint32_t>(values), std::memory_order_release);
  }
  Outputs outputs() const { return static_cast<Outputs>(head_->values.load(std::memory_order_acquire)); }

  /// Notes that the outputs are at their safe values for good, after the guard or in its place.
  void note_safe() noexcept { head_->safe.store(1); }
  bool is_safe() const { return head_->safe.load() != 0; }

  void tell(GuardState state, const std::string& reason) noexcept;
  GuardState state() const { return static_cast<GuardState>(head_->state.load(std::memory_order_acquire)); }
  std::string reason() const { return head_->reason.data(); }
  void put_reports(const std::string& lines) noexcept;
  std::string reports() const { return head_->reports.data(); }

 private:
  struct Head {
    std::atomic<std::uint32_t> beats{0}, request{0}, state{0}, inputs_lock{0}, commands_lock{0}, asleep{0},
        values{0}, safe{0};
    std::atomic<int> processor{-1};  // of the last beat
    std::atomic<std::int64_t> read_at{0};
    int loop = 0;
    std::size_t inputs = 0, outputs = 0, call = 0;
    std::array<char, 512> reason{};
    std::array<char, 4096> reports{};
  };
  static_assert(std::atomic<double>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);

  std::atomic<double>* numbers() const;
  std::size_t call_offset() const;
  void map(std::size_t bytes);

  io::Descriptor memory_;
  std::size_t bytes_ = 0;
  Head* head_ = nullptr;
};

}  // namespace stepwire::guard
