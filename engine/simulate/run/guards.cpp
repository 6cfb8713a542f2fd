#include "engine/simulate/run/guards.hpp"

#include <algorithm>

namespace stepwire::run {

void Guards::changed(std::size_t index, bool was) {
  const plan::PlannedGuard& guard = guards_[index];
  const bool is = active(index);
  if (was && (!is || guard.once_per_edge)) switch_off(guard);
  if (is && (!was || guard.once_per_edge)) reset(guard);
}

void Guards::keep() {
  for (const plan::PlannedGuard& guard : guards_)
    if (values_[guard.active] != 0.0)
      for (const plan::Copied& piece : guard.keep)
        std::copy_n(values_ + piece.from, piece.size, values_ + piece.to);
}

/// Switches off a guard and all guards inside it.
void Guards::switch_off(const plan::PlannedGuard& guard) {
  for (const int inside : guard.inside) {
    const plan::PlannedGuard& inner = guards_[static_cast<std::size_t>(inside)];
    if (values_[inner.active] != 0.0) switch_off(inner);
    values_[inner.active] = 0.0;
  }
  for (const plan::Copied& piece : guard.keep)
    if (piece.from != plan::Layout::time) std::copy_n(values_ + piece.to, piece.size, values_ + piece.from);
  for (const plan::SignalSlot& slope : guard.slopes) std::fill_n(values_ + slope.offset, slope.size, 0.0);
}

void Guards::reset(const plan::PlannedGuard& guard) {
  for (const plan::Copied& piece : guard.reset)
    std::copy_n(values_ + piece.from, piece.size, values_ + piece.to);
  for (const std::size_t block : guard.start) start_(block);
}

}  // namespace stepwire::run
