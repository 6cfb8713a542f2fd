#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/model/block/block_type.hpp"
#include "engine/model/block/outline.hpp"

namespace stepwire {

struct Answer {
  double distance;
  std::vector<double> nearest, direction;
};

/// A Region block whose outputs are computed without a run.
class RegionRig {
 public:
  /// `shape` is the text of this key in a file.
  explicit RegionRig(const std::string& shape);
  Answer at(std::vector<double> position);
  Outline outline() const;

 private:
  AnyBlock block_;
  std::vector<double> position_, nearest_, direction_;
  double distance_ = 0.0;
};

/// A curve of a test's own, over 0 to 1; what is not `kept` is no boundary.
struct Edge {
  std::function<std::vector<double>(double t)> at;
  std::function<bool(const std::vector<double>& point)> kept = [](const auto&) { return true; };
};

/// The least distance from a position to edges, by trying many points and searching between the best.
double brute_force(const std::vector<Edge>& edges, const std::vector<double>& from);

/// With what message a shape is refused; empty if it is not.
std::string refusal_of(const std::string& shape);

}  // namespace stepwire
