#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/simulate/realtime/counter.hpp"

namespace stepwire::realtime {

/// What a loop does about deadlines that it has missed before their step could begin.
struct Overrun {
  enum class Kind {
    skip,      ///< drops them: diagram time stands still for their periods
    catch_up,  ///< serves each of them, late, until it is on time again
    stop       ///< drops them, and ends the loop after `misses` in a row
  };
  Kind kind = Kind::skip;
  std::int64_t misses = 0;

  bool operator==(const Overrun&) const = default;
};

/// Reads "skip", "catch-up", "stop:3"; nothing if it is none of them.
std::optional<Overrun> parse_overrun(std::string_view text);
/// The same word.
std::string overrun_text(const Overrun& overrun);

/// The deadlines of a loop, start + k / rate for k = 0, 1, ..., and what became of them.
///
/// A deadline is served by one step and missed if that step's outputs are not written before the next
/// deadline: because they came late, or because the deadline was dropped. All times are in ns.
class Deadlines {
 public:
  Deadlines(double rate, Overrun overrun)
      : period_(1e9L / static_cast<long double>(rate)), overrun_(overrun) {}

  /// The deadline that is next to be served, from 0.
  std::int64_t index() const { return index_; }
  /// Computed from k alone, so that no rounding adds up.
  std::int64_t at(std::int64_t k) const;
  /// Begins again at `time` with the deadline that is next.
  void start_at(std::int64_t time) { start_ += time - at(index_); }

  /// Before a step: drops what is already missed, but nothing from deadline `end` on. Returns how many.
  std::int64_t drop_missed(std::int64_t now, std::int64_t end);
  /// After a step: the outputs of deadline index() were written at this time; goes on to the next.
  void served(std::int64_t written);
  /// Has the policy had enough misses in a row?
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
  Counter index_, late_, dropped_, longest_row_;  // which others may read
};

}  // namespace stepwire::realtime
