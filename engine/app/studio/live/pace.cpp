#include "engine/app/studio/live/pace.hpp"

namespace stepwire::live {

namespace {

constexpr double late = 0.02, lost = 0.2, measure = 0.5;  // [s]

}  // namespace

void Pace::begin(double rate, std::int64_t tick, double now) {
  rate_ = rate;
  start_ = marked_ = now;
  first_ = marked_tick_ = tick;
  measured_ = rate;
}

void Pace::begun(std::int64_t tick, double now) {
  if (now - marked_ > measure) {
    measured_ = static_cast<double>(tick - marked_tick_) * step_ / (now - marked_);
    marked_ = now;
    marked_tick_ = tick;
  }
  if (rate_ <= 0.0) return;
  const double behind = now - due(tick, now);
  if (behind > late) ++missed_;
  if (behind <= lost) return;
  start_ = now;
  first_ = tick;
}

}  // namespace stepwire::live
