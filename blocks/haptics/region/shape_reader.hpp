#pragma once

#include <functional>
#include <string>
#include <variant>

#include "blocks/haptics/region/plane_shape.hpp"
#include "blocks/haptics/region/space_shape.hpp"
#include "engine/base/expression/expression.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire {

/// Shape in a file, in the plane or in space.
using AnyShape = std::variant<PlaneShape, SpaceShape>;

/// Reads the shape of a Region from its file and checks it.
class ShapeReader {
 public:
  /// Function that throws a message for a piece of the tree.
  using Refuse = std::function<void(const std::string& message, const Value& where)>;

  explicit ShapeReader(Refuse refuse) : refuse_(std::move(refuse)) {}

  AnyShape read(const Value& tree) const;

 private:
  AnyShape read_kind(const std::string& kind, const Value& tree) const;
  AnyShape read_circle(const Value& tree) const;
  AnyShape read_polygon(const Value& tree) const;
  AnyShape read_corridor(const std::string& key, const Value& tree) const;
  AnyShape read_band(const Value& tree) const;
  AnyShape read_union(const Value& tree) const;
  BandSide read_side(const Value& tree, double low, double high) const;
  BandSide side_of_points(const Value& tree, double low, double high) const;
  BandSide side_of_formula(const Value& tree, double low, double high) const;

  const Value& need(const Value& tree, const std::string& key, const std::string& example) const;
  double read_length(const Value& tree, const std::string& what) const;
  double read_positive(const Value& tree, const std::string& what) const;
  std::vector<double> read_lengths(const Value& tree, const std::string& what) const;
  std::vector<std::vector<double>> read_points(const Value& tree, std::size_t least) const;
  std::vector<Vector2> read_plane_points(const Value& tree, std::size_t least) const;
  bool read_closed(const Value& tree) const;
  [[noreturn]] void refuse(const std::string& message, const Value& where) const;

  Refuse refuse_;
};

/// Returns a quantity in SI: a number with a unit of this dimension or none, or a formula of numbers; not
/// finite for any other text.
double quantity_in(const std::string& text, const std::string& unit);

}  // namespace stepwire
