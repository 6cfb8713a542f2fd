// Inputs that need signals of one kind, and sizes that a declaration leaves
// open.
#include <fmt/format.h>

#include "tests/random/smooth.hpp"
#include "tests/random/values.hpp"

namespace stepwire::random {

namespace {

/// The same signal between two numbers.
Wire limited(Making& making, const Wire& wire, double lower, double upper) {
  Bench& bench = making.bench;
  const std::string name = bench.next_name();
  bench.add({name,
             {{"block", "Saturation"},
              {"u", wire.text},
              {"lower", Bench::plain(lower, wire.unit)},
              {"upper", Bench::plain(upper, wire.unit)}}});
  bench.wires.push_back({name, wire.shape, wire.unit});
  return bench.wires.back();
}

Wire of_unit(Making& making, const InputSpec& input, const Shape& shape) {
  const Wire wire = making.bench.wire(shape);
  making.units.take(input.unit, wire.unit);
  const auto unit = making.units.value(input.unit);
  return unit ? making.bench.in_unit(wire, *unit) : wire;
}

Wire constant(Making& making, const InputSpec& input, const Shape& shape, const std::string& value) {
  making.units.take(input.unit, {});
  const std::string name = making.bench.next_name();
  making.bench.add({name, {{"block", "Constant"}, {"value", value}}});
  making.bench.wires.push_back({name, shape, making.units.value(input.unit).value_or(unit::Dimension{})});
  return making.bench.wires.back();
}

/// A delay of a step at least. In a smooth diagram it has 6 steps, so that the past around it is known.
Wire of_transport(Making& making, const InputSpec& input, const Shape& shape) {
  Bench& bench = making.bench;
  const unit::Dimension seconds = *making.units.value("s");
  if (bench.smooth) return {Bench::plain(bench.step * some_steps(bench, 6, 20), seconds), {}, seconds};
  if (making.dice().chance(0.6))
    return {bench.number(bench.step * making.dice().between(1.0, 0.3 * bench.ticks), seconds), {}, seconds};
  making.moving_delay = true;
  return limited(making, of_unit(making, input, shape), bench.step, bench.step * 20);
}

using SpecialWire = Wire (*)(Making& making, const InputSpec& input, const Shape& shape);

Wire positive(Making& making, const InputSpec& input, const Shape& shape) {
  return limited(making, of_unit(making, input, shape), 0.15, 3.0);
}

Wire within_one(Making& making, const InputSpec& input, const Shape& shape) {
  return limited(making, of_unit(making, input, shape), -0.95, 0.95);
}

Wire invertible(Making& making, const InputSpec& input, const Shape& shape) {
  return constant(making, input, shape, matrix_text(making, shape.rows, shape.rows, 2.0, 3.0, 0.5));
}

/// Something that is true as long as numbers are small.
Wire holds(Making& making, const InputSpec&, const Shape&) {
  const Wire wire = making.bench.wire({});
  const std::string name = making.bench.next_name();
  making.bench.add({name,
                    {{"block", "Compare"},
                     {"u", wire.text},
                     {"to", Bench::plain(making.dice().chance(0.1) ? 1.0 : 1e6, wire.unit)},
                     {"operator", "less"}}});
  making.bench.wires.push_back({name, {}, {}});
  return making.bench.wires.back();
}

const std::map<std::string, SpecialWire>& special_wires() {
  static const std::map<std::string, SpecialWire> wires{
      {"Assert.u", holds},
      {"Divide.denominator", positive},
      {"DriftEstimator.precision", positive},
      {"DrivenLinkage.position", within_one},
      {"HeadingPosterior.precision", positive},
      {"Interlock.faults", within_one},
      {"Inverse.u", invertible},
      {"Linkage.external", within_one},
      {"PositionEstimate.precision", positive},
      {"Sqrt.u", positive},
      {"TransportDelay.delay", of_transport},
      {"VariableDelay.delay", [](Making& making, const InputSpec& input, const Shape& shape) {
         return limited(making, of_unit(making, input, shape), 0.0, making.bench.step * 20);
       }}};
  return wires;
}

using Preparation = void (*)(Making& making);

/// A turn by angles, by axis and angle, or by a quaternion.
void prepare_turn(Making& making) {
  making.inputs_are_chosen = true;
  const int way = making.dice().whole(0, 2);
  if (way == 0) making.fed.insert("angles");
  if (way == 1) making.fed.insert({"axis", "angle"});
  if (way == 2) making.fed.insert("quaternion");
}

void prepare_linkage(Making& making) {
  making.shapes["n"] = {3, 1};
  making.shapes["d"] = {2, 1};
}

void prepare_plane(Making& making) {
  making.shapes["n"] = {2, 1};
}

void prepare_model(Making& making) {
  making.shapes["n"] = {making.dice().whole(1, 3), 1};
  making.inputs_are_chosen = true;
  if (making.dice().chance(0.3)) making.fed.insert("reset");
  if (making.dice().chance(0.2)) making.fed.insert("initial");
  if (!making.dice().chance(0.6)) return;
  making.fed.insert("u");
  const Shape inputs{making.dice().whole(1, 2), 1};
  making.shapes["m"] = inputs;
  making.set("B", matrix_text(making, making.size("n"), inputs.rows, -1.0, 1.0, 1.0));
}

void prepare_order(Making& making) {
  making.shapes["n"] = {making.dice().whole(1, 3), 1};
}

void prepare_pid(Making& making) {
  making.fed.insert("reference");
}

void prepare_vector(Making& making) {
  making.shapes["n"] = {making.dice().whole(1, 4), 1};
}

void prepare_motion(Making& making) {
  making.shapes["d"] = {making.dice().whole(2, 3), 1};
  making.inputs_are_chosen = true;
}

void prepare_layers(Making& making) {
  making.fed.insert("regions");
}

void prepare_chart(Making& making) {
  making.fed.insert("u");
  making.shapes["m"] = making.shapes["c"] = {1, 1};
}

const std::map<std::string, Preparation>& preparations() {
  static const std::map<std::string, Preparation> all{
      {"Counter", [](Making& making) { making.fed.insert("u"); }},
      {"Demux", prepare_vector},
      {"Directionality", [](Making& making) { making.fed.insert("position"); }},
      {"DiscreteLuenbergerObserver", prepare_model},
      {"DiscreteTransferFunction", prepare_order},
      {"DrivenLinkage", prepare_linkage},
      {"KalmanFilter", prepare_model},
      {"LayerActivator", prepare_layers},
      {"Linkage", prepare_linkage},
      {"LuenbergerObserver", prepare_model},
      {"PID", prepare_pid},
      {"DiscretePID", prepare_pid},
      {"PathDrift", prepare_vector},
      {"Region", prepare_plane},
      {"Rotate3D", prepare_turn},
      {"RotationMatrix", prepare_turn},
      {"Select", prepare_vector},
      {"StateMachine", prepare_chart},
      {"StraightMotion", prepare_motion},
      {"Pusher",
       [](Making& making) {
         making.shapes["d"] = {2, 1};
       }},
      {"TransferFunction", prepare_order}};
  return all;
}

}  // namespace

void prepare(Making& making) {
  const auto found = preparations().find(making.type.name);
  if (found != preparations().end()) found->second(making);
}

std::size_t list_count(Making& making, const InputSpec& input) {
  static const std::map<std::string, std::size_t> fixed{
      {"Cross.u", 2}, {"Dot.u", 2}, {"LayerActivator.u", 2}, {"LayerActivator.regions", 2}};
  if (input.name == "precision")
    return making.counts[making.type.name == "HeadingPosterior" ? "direction" : "measured"];
  const auto found = fixed.find(making.type.name + "." + input.name);
  if (found != fixed.end()) return found->second;
  if (making.type.name == "LookupTableND" || making.type.name == "Expression")
    return static_cast<std::size_t>(making.dice().whole(1, 2));
  return static_cast<std::size_t>(making.dice().whole(1, 3));
}

bool has_special_wire(const Making& making, const InputSpec& input) {
  return special_wires().contains(making.type.name + "." + input.name);
}

std::optional<Wire> special_wire(Making& making, const InputSpec& input, const Shape& shape) {
  const auto found = special_wires().find(making.type.name + "." + input.name);
  if (found == special_wires().end()) return std::nullopt;
  return found->second(making, input, shape);
}

}  // namespace stepwire::random
