#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/simulate/realtime/counter.hpp"

namespace stepwire::realtime {

/// Policy for deadlines that were missed before their step could begin.
struct Overrun {
  enum class Kind {
    skip,      ///< drops them: diagram time does not advance for their periods
    catch_up,  ///< serves each of them, late, until the loop is on time again
    stop       ///< drops them, and ends the loop after `misses` successive misses
  };
  Kind kind = Kind::skip;
  std::int64_t misses = 0;

  bool operator==(const Overrun&) const = default;
};

/// Parses "skip", "catch-up" or "stop:3"; std::nullopt for any other text.
std::optional<Overrun> parse_overrun(std::string_view text);
/// Returns the text of parse_overrun().
std::string overrun_text(const Overrun& overrun);

/// Deadlines of a loop, start + k / rate for k = 0, 1, ..., and counts of the missed ones.
///
/// A deadline is served by one step. It is missed if that step's outputs are not written before the next
/// deadline, either because they are late or because the deadline was dropped. All times are in ns.
class Deadlines {
 public:
  Deadlines(double rate, Overrun overrun)
      : period_(1e9L / static_cast<long double>(rate)), overrun_(overrun) {}

  /// Returns the index of the next deadline, from 0.
  std::int64_t index() const { return index_; }
  /// Returns the time of deadline k, computed from k alone so that rounding does not accumulate.
  std::int64_t at(std::int64_t k) const;
  /// Moves the next deadline to `time`.
  void start_at(std::int64_t time) { start_ += time - at(index_); }

  /// Drops, before a step, the deadlines that are already missed, up to `end` (exclusive). Returns their
  /// count.
  std::int64_t drop_missed(std::int64_t now, std::int64_t end);
  /// Stores, after a step, when the outputs of deadline index() were written, and advances to the next one.
  void served(std::int64_t written);
  /// True once the policy requires the loop to end.
  bool must_stop() const { return overrun_.kind == Overrun::Kind::stop && row_ >= overrun_.misses; }

  std::int64_t late() const { return late_; }
  std::int64_t dropped() const { return dropped_; }
  std::int64_t missed() const { return late_ + dropped_; }
  std::int64_t longest_row() const { return longest_row_; }

 private:
  void miss();

  long double period_;
  Overrun overrun_;
  std::int64_t start_ = 0, row_ = 0;
  Counter index_, late_, dropped_, longest_row_;  // read by other threads
};

}  // namespace stepwire::realtime
