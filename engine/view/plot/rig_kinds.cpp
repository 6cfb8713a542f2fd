#include "engine/view/plot/rig.hpp"

namespace stepwire::plot {
namespace {

constexpr std::size_t any_number = 1000;

}  // namespace

const std::vector<RigKind>& rig_kinds() {
  static const std::vector<RigKind> kinds{
      {"damper", "it takes two: where its housing is held, and the end of its rod"},
      {"motor", "a linear motor takes two: where its housing is held, and the end of its rod"},
      {"spring", "it takes two ends"},
      {"rod", "it takes two ends"},
      {"potentiometer",
       "a string potentiometer beside a link takes two: where it is held, and the end of its string"},
      {"lvdt", "beside a link, it takes two: where it is held, and the end of its core"},
      {"dashpot", "it takes two ends"},
      {"bouc_wen", "it takes two ends"},
      {"load_cell", "it takes the two ends of the link at whose second end it is"},
      {"arrow", "it takes two: its beginning and its tip"},
      {"force", "it takes the point at which it acts", 1, 1, true},
      {"motion", "it takes the point that goes to and fro", 1, 1, true},
      {"torque", "it takes the point about which it turns", 1, 1},
      {"axis", "it takes two ends"},
      {"dimension", "it takes the two points whose distance it shows"},
      {"ground", "it takes the joints that are at the ground", 1, any_number},
      {"universal", "it takes the universal joints that are at the ground", 1, any_number},
      {"pin", "it takes the joints that are drawn", 1, any_number},
      {"end_effector", "it takes one point", 1, 1},
      {"carriage", "it takes the point at which its damper ends", 1, 1},
      {"shaker", "it takes the point that it moves, along x or in its direction", 1, 1, true},
      {"rotary_damper", "it takes its centre", 1, 1},
      {"slide", "it takes the point that slides", 1, 1, true},
      {"box", "a body takes two opposite corners"},
      {"wall", "it takes two ends; what stands on it lies to the right of the way"},
      {"base", "it takes the corners of a plate, or two opposite ones", 2, any_number},
      {"workspace", "it takes two opposite corners, or the corners of a polygon", 2, any_number},
      {"path", "it takes one point, whose way is drawn", 1, 1},
  };
  return kinds;
}

}  // namespace stepwire::plot
