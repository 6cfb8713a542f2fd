#pragma once

#include <optional>
#include <string>

#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/place.hpp"

namespace stepwire::tuning {

/// On which scale a parameter is searched.
enum class TuneScale { automatic, linear, logarithmic };

/// A parameter of the diagram that is tuned. Numbers are SI.
struct TuneParameter {
  std::string name;  ///< as --set takes it: "rig.kp"
  double start = 0.0, lower = 0.0, upper = 0.0;
  TuneScale scale = TuneScale::automatic;
  std::optional<unit::Dimension> dimension{};
  std::string unit{};  ///< in which the author wrote it, for showing the value; empty: SI
  yaml::Place place{};

  /// Evenly in the logarithm, by itself where the bounds are more than tenfold apart.
  bool is_logarithmic() const;
  /// The value at a share of the way between the bounds, 0 to 1, and back.
  double at(double share) const;
  double share_of(double value) const;
};

}  // namespace stepwire::tuning
