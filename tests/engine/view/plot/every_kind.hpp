#pragma once

#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::testing {

/// A plot of each kind that has axes, with most of its keys.
inline const std::vector<std::string> every_kind{
    "{plot: lines, x: time, y: [rig.x in mm, rig.v*1 s in mm], reference: [1 mm, rig.x in mm]}",
    "{plot: lines, x: time, y: [rig.x in mm, {signal: 2*rig.x in mm, label: twice}]}",
    "{plot: lines, x: time, y: rig.x in mm, by: current}",
    "{plot: lines, x: current, y: push.force, rows: final, log: [x, y]}",
    "{plot: xy, x: rig.x in mm, y: rig.v in mm/s}",
    "{plot: loop, x: rig.x in mm, y: push.force, by: current}",
    "{plot: path, x: rig.x in mm, y: time, color: push.force, boundary: [x - 0.5 mm, y - x*1000 - 0.2]}",
    "{plot: strip, x: rig.x in mm, color: push.force in N}",
    "{plot: map, x: rig.x in mm, y: current, color: rig.v, contour: [0, 1 mm/s]}",
    "{plot: field, x: rig.x in mm, y: current in mA, u: rig.v, v: rig.v}",
    "{plot: 3d, x: rig.x in mm, y: rig.v in mm/s, z: current, color: time}",
    "{plot: 3d, x: rig.x in mm, y: rig.v in mm/s, z: current, style: points, equal: true}",
    "{plot: 3d, x: rig.x in mm, y: rig.v in mm/s, z: current, color: time, sheets: [current < 0.25, current "
    "> 0.15]}",
    "{plot: box, y: rig.x in mm, by: current}",
    "{plot: box, y: rig.x in mm, by: current, beside: {signal: rig.v > 0, label: forth}, whiskers: tukey}",
    "{plot: box, y: [rig.x in mm, rig.x*2 in mm], reference: [0.5 mm, {signal: 1 mm, label: theirs}]}",
    "{plot: tornado, x: rig.x in mm, by: current, to: current}",
    "{plot: histogram, x: rig.x in mm}",
    "{plot: band, x: time, y: rig.x in mm, by: current, shares: [50 %, 0.9]}"};

}  // namespace stepwire::testing
