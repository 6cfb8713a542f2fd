#pragma once

#include <map>
#include <set>
#include <string>

namespace stepwire {

/// Values of parameters that their declaration alone does not give, or with whose defaults a block does
/// nothing.
inline const std::map<std::string, std::string> contract_values{
    {"Delay.delay", "5 ms"},
    {"Demux.sizes", "[1, 2]"},
    {"DrivenLinkage.anchors", "[[2, 0], [0, 2], [-1, -1]]"},
    {"DrivenLinkage.pin_mass", "1"},
    {"DrivenLinkage.rod_mass", "0.5"},
    {"DrivenLinkage.rod_centre", "0.1"},
    {"DrivenLinkage.housing_inertia", "0.2"},
    {"FromFile.column", "x"},
    {"FromFile.file", "contract_record.csv"},
    {"FromFile.prepare", "[{low_pass: 100 Hz, order: 2}, {differentiate: 1}]"},
    {"Hysteresis.lower", "0.6"},
    {"Linkage.anchors", "[[2, 0], [0, 2], [-1, -1]]"},
    {"Linkage.pin_mass", "1"},
    {"Linkage.rod_mass", "0.5"},
    {"Linkage.rod_centre", "0.1"},
    {"Linkage.housing_inertia", "0.2"},
    {"InversePolynomial.range", "[0.4, 3]"},
    {"LayerActivator.switches",
     "[{from: 1, to: 2, when: [{enter: 1}, {after: 4 ms}]}, {from: 2, to: 1, when: {leave: 2}}, "
     "{from: 1, to: 2, when: {pass: [0.9, 0.9], within: 0.1}}]"},
    {"LayerActivator.blend", "5 ms"},
    {"LoadCell.calibration",
     "[[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0], "
     "[0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]"},
    {"LoadCellToWrench.calibration",
     "[[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0], "
     "[0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]"},
    {"MatrixGain.gain", "[[1, 2], [3, 4]]"},
    {"MovingAverage.window", "5 ms"},
    {"GuidePath.trail", "2 mm"},
    {"ReOrigin.margin", "1 mm"},
    {"Reshape.rows", "3"},
    {"Select.indices", "[2, 1]"},
    {"Slice.rows", "[2, 1]"},
    {"Slice.columns", "[1]"},
    {"Interval.lower", "-1"},
    {"Interval.upper", "0.5"},
    {"Proportionality.maximum", "5"},
    {"Proportionality.points", "[0, 1]"},
    {"Proportionality.values", "[0, 4]"},
    {"Pusher.points", "[[0, 0], [3 mm, 1 mm], [0, 2 mm]]"},
    {"Proportionality.offset", "1"},
    {"Proportionality.slope", "2"},
    {"StraightMotion.direction", "[3, 4]"},
    {"StraightMotion.from", "[1, 2]"},
    {"Region.shape", "{union: [{center: [0.5, 0.7], radius: 0.1}, {polygon: [[2, 0], [4, 0], [4, 1]]}]}"},
    {"StateMachine.states",
     "{idle: {output: [1], to: {busy: \"after >= 3 ms\"}}, "
     "busy: {output: [2], history: true, enter: {n: n + 1}, to: {idle: \"after >= 6 ms || u1 > 1.2\"}, "
     "states: {slow: {to: {fast: \"after >= 2 ms\"}}, fast: {each: {n: n + u1}, to: {slow: \"after >= 50 "
     "ms\"}}}}}"},
    {"StateMachine.counters", "{n: 0}"},
    {"DiscreteStateSpace.A", "[[0.5, 0.2], [0, 0.3]]"},
    {"DiscreteStateSpace.B", "[[1], [1]]"},
    {"DiscreteStateSpace.C", "[[1, 1]]"},
    {"KalmanFilter.A", "[[0.5, 0.2], [0, 0.3]]"},
    {"KalmanFilter.B", "[[1], [1]]"},
    {"KalmanFilter.C", "[[1, 1]]"},
    {"KalmanFilter.Q", "[[1, 0.1], [0.1, 2]]"},
    {"KalmanFilter.R", "[[0.5]]"},
    {"KalmanFilter.P0", "[[2, 0], [0, 2]]"},
    {"DiscreteLuenbergerObserver.A", "[[0.5, 0.2], [0, 0.3]]"},
    {"DiscreteLuenbergerObserver.B", "[[1], [1]]"},
    {"DiscreteLuenbergerObserver.C", "[[1, 1]]"},
    {"DiscreteLuenbergerObserver.L", "[[0.1], [0.2]]"},
    {"LuenbergerObserver.A", "[[-1, 2], [0, -3]]"},
    {"LuenbergerObserver.B", "[[1], [1]]"},
    {"LuenbergerObserver.C", "[[1, 1]]"},
    {"LuenbergerObserver.L", "[[0.1], [0.2]]"},
    {"LookupTableND.points", "[[0, 1], [0, 1, 2]]"},
    {"LookupTableND.values", "[[1, 2, 4], [3, 5, 7]]"},
    {"StateSpace.A", "[[-1, 2], [0, -3]]"},
    {"StateSpace.B", "[[1], [1]]"},
    {"StateSpace.C", "[[1, 1]]"},
    {"StuckDetector.time", "3 ms"},
    {"StuckDetector.tolerance", "1"},
};

/// Sizes that an input needs where nothing else fixes them.
inline const std::map<std::string, int> contract_sizes{{"Cross.u", 3},
                                                       {"Demux.u", 3},
                                                       {"DiscreteLuenbergerObserver.initial", 2},
                                                       {"DiscreteLuenbergerObserver.value", 2},
                                                       {"DiscreteStateSpace.initial", 2},
                                                       {"DiscreteStateSpace.value", 2},
                                                       {"KalmanFilter.initial", 2},
                                                       {"KalmanFilter.value", 2},
                                                       {"LuenbergerObserver.initial", 2},
                                                       {"LuenbergerObserver.value", 2},
                                                       {"QuaternionIntegrator.initial", 4},
                                                       {"QuaternionIntegrator.rate", 3},
                                                       {"QuaternionIntegrator.value", 4},
                                                       {"QuaternionProduct.left", 4},
                                                       {"QuaternionProduct.right", 4},
                                                       {"Rotate3D.angles", 3},
                                                       {"Rotate3D.axis", 3},
                                                       {"Rotate3D.quaternion", 4},
                                                       {"Rotate3D.u", 3},
                                                       {"StateSpace.initial", 2},
                                                       {"StateSpace.value", 2},
                                                       {"DrivenLinkage.acceleration", 2},
                                                       {"DrivenLinkage.force", 3},
                                                       {"DrivenLinkage.position", 2},
                                                       {"DrivenLinkage.torque", 3},
                                                       {"DrivenLinkage.velocity", 2},
                                                       {"LayerActivator.position", 2},
                                                       {"Linkage.external", 2},
                                                       {"Linkage.force", 3},
                                                       {"Linkage.torque", 3},
                                                       {"LoadCell.force", 3},
                                                       {"LoadCell.torque", 3},
                                                       {"LoadCellToWrench.gauges", 6},
                                                       {"Reshape.u", 3},
                                                       {"Rotate.u", 2},
                                                       {"RotationMatrix.angles", 3},
                                                       {"RotationMatrix.axis", 3},
                                                       {"RotationMatrix.quaternion", 4},
                                                       {"Select.u", 3},
                                                       {"Slice.u", 2}};

/// Where what feeds an input starts, on its way to 1; else at a half and more.
inline const std::map<std::string, double> contract_starts{{"Interlock.faults", -1.9}};

/// Optional inputs that the values above need.
inline const std::set<std::string> contract_inputs{"Directionality.force", "LayerActivator.regions",
                                                   "Rotate3D.angles", "RotationMatrix.angles",
                                                   "StateMachine.u"};

}  // namespace stepwire
