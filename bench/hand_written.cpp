#include "bench/hand_written.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stepwire {

namespace {

constexpr double h = 0.001;

double hand(double time) {
  return 2.0 * std::sin(std::numbers::pi * time + 0.3);
}

}  // namespace

template <int level>
double HandWrittenW1<level>::force(const std::array<double, 4>& s) const {
  const double i = std::clamp(s[3], 0.0, 0.35);
  const double c = (((-9.37 * i + 10.22) * i - 4.33) * i + 0.89) * i + 0.02;
  const double alpha = ((72.8 * i - 42.88) * i + 14.83) * i + 0.29;
  return c * s[1] + alpha * s[2];
}

template <int level>
std::array<double, 4> HandWrittenW1<level>::slope(double time, const std::array<double, 4>& s) const {
  const double v = s[1], z = s[2];
  const double net = 5.0 * hand(time) - force(s);
  return {v, 1000.0 * (1.0 * net), 36.2095 * v - 10.614 * (std::abs(v) * z) - -7.0773 * (v * std::abs(z)),
          (held_current_ - s[3]) * (1.0 / 0.005)};
}

template <int level>
void HandWrittenW1<level>::control(double time) {
  const double x = 0.02 * std::floor(state_[0] / 0.02 + 0.5);
  const double region = x > 5.0 ? x - 5.0 : x < -4.0 ? x + 4.0 : 0.0;
  const double gate = region * (5.0 * hand(time));
  const double wanted = gate > 0.0 ? std::abs(region) + 2.0 : 0.0;
  const double error = wanted - std::abs(force(state_));
  const double output = 0.005 * error + integral_ + 1e-5 * ((error - last_error_) / 0.001);
  integral_ = std::clamp(integral_ + 0.5 * 0.001 * error, 0.0, 0.35);
  last_error_ = error;
  held_current_ = std::clamp(output, 0.0, 0.35);
}

template <int level>
void HandWrittenW1<level>::step() {
  const double time = static_cast<double>(tick_++) * h;
  control(time);
  const auto moved = [&](const std::array<double, 4>& k, double by) {
    std::array<double, 4> s = state_;
    for (std::size_t n = 0; n < s.size(); ++n) s[n] += by * k[n];
    return s;
  };
  const auto k1 = slope(time, state_);
  const auto k2 = slope(time + h / 2, moved(k1, h / 2));
  const auto k3 = slope(time + h / 2, moved(k2, h / 2));
  const auto k4 = slope(time + h, moved(k3, h));
  for (std::size_t n = 0; n < state_.size(); ++n)
    state_[n] += h / 6 * (k1[n] + 2 * k2[n] + 2 * k3[n] + k4[n]);
}

template <int level>
HandWrittenW2<level>::HandWrittenW2(int blocks) {
  const auto cells = static_cast<std::size_t>(blocks / 5);
  for (auto* vector : {&x_, &stage_, &k1_, &k2_, &k3_, &k4_, &gain_, &pass_}) vector->assign(cells, 0.0);
  for (std::size_t j = 0; j < cells; ++j) {
    gain_[j] = static_cast<double>(1 + j % 7);
    pass_[j] = 0.9 + 0.01 * static_cast<double>(j % 5);
  }
}

template <int level>
void HandWrittenW2<level>::slope(double time, const std::vector<double>& x, std::vector<double>& dot) const {
  const double source = std::sin(2.0 * std::numbers::pi * time);
  const double w = 0.1 * source;
  double u = source;
  for (std::size_t j = 0; j < x.size(); ++j) {
    dot[j] = gain_[j] * (u - x[j]);
    u = pass_[j] * x[j] + w;
  }
}

template <int level>
void HandWrittenW2<level>::step() {
  const double time = static_cast<double>(tick_++) * h;
  const auto move = [&](const std::vector<double>& k, double by) {
    for (std::size_t j = 0; j < x_.size(); ++j) stage_[j] = x_[j] + by * k[j];
  };
  slope(time, x_, k1_);
  move(k1_, h / 2);
  slope(time + h / 2, stage_, k2_);
  move(k2_, h / 2);
  slope(time + h / 2, stage_, k3_);
  move(k3_, h);
  slope(time + h, stage_, k4_);
  for (std::size_t j = 0; j < x_.size(); ++j) x_[j] += h / 6 * (k1_[j] + 2 * k2_[j] + 2 * k3_[j] + k4_[j]);
}

template <int level>
double HandWrittenW2<level>::sum() const {
  double sum = 0.0;
  for (double x : x_) sum += x;
  return sum;
}

template class HandWrittenW1<HAND_WRITTEN_LEVEL>;
template class HandWrittenW2<HAND_WRITTEN_LEVEL>;

}  // namespace stepwire
