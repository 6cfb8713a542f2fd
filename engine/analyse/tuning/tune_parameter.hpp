#pragma once

#include <optional>
#include <string>

#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/place.hpp"

namespace stepwire::tuning {

/// Scale on which a parameter is searched.
enum class TuneScale { automatic, linear, logarithmic };

/// A tuned parameter of the diagram. Numbers are SI.
struct TuneParameter {
  std::string name;  ///< Name as in --set: "rig.kp".
  double start = 0.0, lower = 0.0, upper = 0.0;
  TuneScale scale = TuneScale::automatic;
  std::optional<unit::Dimension> dimension{};
  std::string unit{};  ///< Unit in which the value is shown, as the author wrote it; empty: SI.
  yaml::Place place{};

  /// True for a logarithmic scale. With TuneScale::automatic that is so if the bounds differ by more than a
  /// factor of ten.
  bool is_logarithmic() const;
  /// Converts a share of the way between the bounds, 0 to 1, to a value, and back.
  double at(double share) const;
  double share_of(double value) const;
};

}  // namespace stepwire::tuning
