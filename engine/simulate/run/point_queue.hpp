#pragma once

#include <mutex>
#include <vector>

#include "engine/simulate/run/run.hpp"

namespace stepwire::run {

/// Queue of the points of a sweep for several threads. Points are mostly in order, but points that share a
/// plan are grouped if their runs use lanes.
class PointQueue {
 public:
  explicit PointQueue(const Job& job) : job_(job), taken_(job.points.size()) {}

  /// Returns the next points, all of one member: the first one left, and later ones up to `most(first)` in
  /// total. Returns an empty list at the end.
  template <class Most>
  std::vector<std::size_t> take(const Most& most) {
    const std::lock_guard lock(mutex_);
    while (first_ < taken_.size() && taken_[first_]) ++first_;
    std::vector<std::size_t> points;
    if (first_ == taken_.size()) return points;
    const std::size_t member = job_.points[first_].member, count = most(first_);
    const std::size_t end = std::min(taken_.size(), first_ + reach * count);
    for (std::size_t point = first_; point < end && points.size() < count; ++point)
      if (!taken_[point] && job_.points[point].member == member) {
        taken_[point] = true;
        points.push_back(point);
      }
    return points;
  }

 private:
  static constexpr std::size_t reach = 64;  ///< search distance ahead, per point

  const Job& job_;
  std::mutex mutex_;
  std::size_t first_ = 0;
  std::vector<bool> taken_;
};

}  // namespace stepwire::run
