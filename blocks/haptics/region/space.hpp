#pragma once

#include <cmath>

#include "engine/base/math/elementary.hpp"

namespace stepwire {

/// Point or direction in space [m].
struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;
};

inline Vector3 operator+(Vector3 a, Vector3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector3 operator-(Vector3 a, Vector3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector3 operator*(double by, Vector3 a) {
  return {by * a.x, by * a.y, by * a.z};
}
inline double dot(Vector3 a, Vector3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double length(Vector3 a) {
  const double square = dot(a, a);
  return square > 0x1p-900 && square < 0x1p1000 ? std::sqrt(square) : fn::hypot(a.x, a.y, a.z);
}
/// Returns a unit vector perpendicular to a, always the same one.
inline Vector3 beside(Vector3 a) {
  const Vector3 raw = a.y * a.y < 0.5 * dot(a, a) ? Vector3{a.z, 0.0, -a.x} : Vector3{a.y, -a.x, 0.0};
  return (1.0 / length(raw)) * raw;
}

}  // namespace stepwire
