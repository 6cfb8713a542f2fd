#include "blocks/haptics/region.hpp"

#include "blocks/haptics/region/shape_reader.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

void Region::configure(Configure& is) {
  const ShapeReader reader(
      [&](const std::string& message, const Value& where) { is.refuse<&Region::shape>(message, where); });
  const AnyShape read = reader.read(shape.value());
  const auto* space = std::get_if<SpaceShape>(&read);
  is.size("n", space ? 3 : 2);
  if (space) {
    solids = Numbers(numbers_of(*space));
    return;
  }
  const BoundaryTable table(std::get<PlaneShape>(read));
  pieces = Numbers(table.pieces);
  sleeves = Numbers(table.sleeves);
  tolerance = table.tolerance;
}

void Region::declare(Declare<Region>& is) {
  is.block(
      "Region",
      {.doc =
           "Authorized region of any shape in the plane or in space: the signed distance from its boundary, "
           "positive outside, the nearest point of the boundary, and the direction in which the distance "
           "grows. `shape` is one of {center, radius, inner_radius}, a circle or annulus, with three "
           "coordinates a sphere or shell; {polygon: [corners]}; {corridor: [points], half_width, closed}, "
           "all within half_width of the line through the points; {spline: [points], half_width, closed}, "
           "the same about a smooth curve; {left, right, y: [low, high]}, all x between two functions of y, "
           "each a formula of y or a list of points, one of which may be left out; {union: [shapes]}. Where "
           "several boundary points are equally near, the first along the boundary as the file gives it "
           "counts; at the centre of a circle or sphere that is the one in direction x. On the boundary "
           "itself, direction is its normal. Curves are followed to 0.5 nm. In space corridors are straight, "
           "and shapes of a union apart from each other.",
       .source = "thesis 2.4.2, figures 2, 10 and 22"});
  is.parameter<&Region::shape>(
      {.doc = "the region; lengths carry units, or are in metres", .required = true});
  is.input<&Region::position>({.unit = "m", .shape = "n", .doc = "where to look, x and y, in space z too"});
  is.output<&Region::distance>({.unit = "m", .doc = "distance from the boundary, negative inside"});
  is.output<&Region::nearest>({.unit = "m", .shape = "n", .doc = "the boundary point that is nearest"});
  is.output<&Region::direction>(
      {.shape = "n", .doc = "unit vector in which the distance grows: from the region outward"});
  is.derived<&Region::pieces>();
  is.derived<&Region::sleeves>();
  is.derived<&Region::solids>();
  is.derived<&Region::tolerance>();
}

}  // namespace stepwire
