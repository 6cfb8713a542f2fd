#include "engine/app/studio/live/moments.hpp"

#include <algorithm>

namespace stepwire::live {

namespace {

/// Returns the first checkpoint after a tick.
auto behind(const std::vector<run::Workspace>& kept, std::int64_t tick) {
  return std::ranges::upper_bound(kept, tick, {}, &run::Workspace::tick);
}

}  // namespace

void Moments::keep(const run::Workspace& workspace) {
  next_ = (workspace.tick / every_ + 1) * every_;
  kept_.push_back(workspace);
  const std::size_t each = sizeof(run::Workspace) + workspace.values.size() * sizeof(double);
  if (kept_.size() > std::max<std::size_t>(8, bytes_ / each)) thin();
}

/// Removes the checkpoint with the smallest gap between its neighbours relative to its age. The spacing thus
/// grows in proportion to the age. The first and the newest checkpoint are never removed. Cost: one pass.
void Moments::thin() {
  std::size_t least = 1;
  double best = 0.0;
  const auto newest = static_cast<double>(kept_.back().tick);
  for (std::size_t i = 1; i + 1 < kept_.size(); ++i) {
    const auto gap = static_cast<double>(kept_[i + 1].tick - kept_[i - 1].tick);
    const double age = newest - static_cast<double>(kept_[i].tick) + 1.0;
    if (i > 1 && age / gap <= best) continue;
    best = age / gap;
    least = i;
  }
  kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(least));
}

const run::Workspace* Moments::before(std::int64_t tick) const {
  const auto found = behind(kept_, tick);
  return found == kept_.begin() ? nullptr : &*(found - 1);
}

void Moments::cut(std::int64_t tick) {
  kept_.erase(behind(kept_, tick), kept_.end());
  next_ = kept_.empty() ? 0 : (kept_.back().tick / every_ + 1) * every_;
}

}  // namespace stepwire::live
