#include "tests/blocks/haptics/region_rig.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire {

namespace {

std::string diagram_text(const std::string& shape) {
  const bool space =
      shape.find("center: [0, 0, 0]") != std::string::npos || shape.find("3-D") != std::string::npos;
  return "blocks:\n  map: {block: Region, shape: " + shape +
         ", position: " + (space ? "[0, 0, 0]" : "[0, 0]") + "}\n";
}

double distance_between(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

}  // namespace

RegionRig::RegionRig(const std::string& shape)
    : block_(plan_text(diagram_text(shape)).diagram.blocks[0].block) {}

Outline RegionRig::outline() const {
  Outline outline;
  block_.type().outline(block_.get(), outline);
  return outline;
}

Answer RegionRig::at(std::vector<double> position) {
  position_ = std::move(position);
  nearest_.resize(position_.size());
  direction_.resize(position_.size());
  const BlockType& type = block_.type();
  const auto size = static_cast<Eigen::Index>(position_.size());
  type.inputs[0].bind(block_.get(), position_.data(), size);
  type.outputs[0].bind(block_.get(), &distance_, 1);
  type.outputs[1].bind(block_.get(), nearest_.data(), size);
  type.outputs[2].bind(block_.get(), direction_.data(), size);
  type.run_outputs[Specialization::nothing](block_.get(), static_cast<std::byte*>(block_.get()) + type.bytes);
  return {distance_, nearest_, direction_};
}

namespace {

/// The least of a function that has one minimum between two numbers.
double min_between(const std::function<double(double)>& of, double low, double high) {
  for (int k = 0; k < 60; ++k) {
    const double a = low + 0.382 * (high - low), b = low + 0.618 * (high - low);
    const bool left = of(a) <= of(b);
    low = left ? low : a;
    high = left ? b : high;
  }
  return of(0.5 * (low + high));
}

double brute_force(const Edge& edge, const std::vector<double>& from) {
  constexpr int samples = 500;
  const auto distance = [&](double t) {
    const auto point = edge.at(t);
    return edge.kept(point) ? distance_between(point, from) : std::numeric_limits<double>::infinity();
  };
  std::vector<double> coarse;
  for (int i = 0; i <= samples; ++i) coarse.push_back(distance(static_cast<double>(i) / samples));
  double best = *std::min_element(coarse.begin(), coarse.end());
  for (int i = 0; i <= samples; ++i) {
    const int before = std::max(0, i - 1), behind = std::min(samples, i + 1);
    const double here = coarse[static_cast<std::size_t>(i)];
    if (here <= coarse[static_cast<std::size_t>(before)] &&
        here <= coarse[static_cast<std::size_t>(behind)] && here < best + 1e-4)
      best = std::min(best, min_between(distance, static_cast<double>(before) / samples,
                                        static_cast<double>(behind) / samples));
  }
  return best;
}

}  // namespace

double brute_force(const std::vector<Edge>& edges, const std::vector<double>& from) {
  double best = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges) best = std::min(best, brute_force(edge, from));
  return best;
}

std::string refusal_of(const std::string& shape) {
  return error_of("step: 1 ms\nstop: 1 s\n" + diagram_text(shape));
}

}  // namespace stepwire
