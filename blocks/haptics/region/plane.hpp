#pragma once

#include <cmath>

#include "engine/base/math/elementary.hpp"

namespace stepwire {

/// Point or direction in the plane [m].
struct Vector2 {
  double x = 0.0, y = 0.0;
};

inline Vector2 operator+(Vector2 a, Vector2 b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vector2 operator-(Vector2 a, Vector2 b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vector2 operator*(double by, Vector2 a) {
  return {by * a.x, by * a.y};
}
inline double dot(Vector2 a, Vector2 b) {
  return a.x * b.x + a.y * b.y;
}
/// Returns the cross product; positive if b points to the left of a.
inline double cross(Vector2 a, Vector2 b) {
  return a.x * b.y - a.y * b.x;
}
inline double length(Vector2 a) {
  const double square = dot(a, a);
  return square > 0x1p-900 && square < 0x1p1000 ? std::sqrt(square) : fn::hypot(a.x, a.y);
}
inline Vector2 turned_left(Vector2 a) {
  return {-a.y, a.x};
}
/// Returns the direction at this angle from the x-axis.
inline Vector2 direction_at(double angle) {
  return {fn::cos(angle), fn::sin(angle)};
}

}  // namespace stepwire
