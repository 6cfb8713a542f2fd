#include "engine/analyse/tuning/tune_request.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire::tuning {

bool TuneParameter::is_logarithmic() const {
  if (scale != TuneScale::automatic) return scale == TuneScale::logarithmic;
  return lower * upper > 0.0 && std::max(lower / upper, upper / lower) > 10.0;
}

double TuneParameter::at(double share) const {
  if (share <= 0.0) return lower;
  if (share >= 1.0) return upper;
  return is_logarithmic() ? lower * std::pow(upper / lower, share) : lower + (upper - lower) * share;
}

double TuneParameter::share_of(double value) const {
  const double share = is_logarithmic() ? std::log(value / lower) / std::log(upper / lower)
                                        : (value - lower) / (upper - lower);
  return std::clamp(share, 0.0, 1.0);
}

}  // namespace stepwire::tuning
