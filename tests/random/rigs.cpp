// Blocks that make sense only together: a mass and its friction, a bus and its reader.
#include "tests/random/rigs.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tests/random/smooth.hpp"

namespace stepwire::random {

namespace {

unit::Dimension dimension_of(const char* text) {
  return unit::parse_unit(text)->dimension;
}

void add_wire(Bench& bench, const std::string& text, const char* unit) {
  bench.wires.push_back({text, {}, *unit == '\0' ? unit::Dimension{} : dimension_of(unit)});
}

/// A mass on a spring that is pushed, while its parts are made.
class Body {
 public:
  explicit Body(Bench& bench) : bench_(bench), dice_(bench.dice), duration_(bench.step * bench.ticks) {}

  void make() {
    push_ = bench_.in_unit(bench_.wire({}), dimension_of("N")).text;
    for (std::string* name : {&body_, &spring_, &others_}) *name = bench_.next_name();
    mass_ = dice_.between(0.5, 2.0);
    const double frequency = dice_.between(4.0, 20.0) / duration_;
    bench_.add({spring_,
                {{"block", "Gain"},
                 {"u", body_ + ".position"},
                 {"gain", Bench::plain(-mass_ * frequency * frequency, dimension_of("N/m"))}}});
    bench_.add({others_, {{"block", "Sum"}, {"u", fmt::format("[{}, {}]", push_, spring_)}}});
    forces_ = others_;
    const int kind = dice_.whole(0, 4);
    if (kind == 0 || kind == 4) add_friction();
    if (kind == 1) add_bristles();
    if (kind == 2) add_dahl();
    if (kind >= 3) add_stops();
    add_mass();
  }

 private:
  std::string number(double value, const char* unit) { return bench_.number(value, dimension_of(unit)); }
  std::string own_mass() const { return Bench::plain(mass_, dimension_of("kg")); }
  /// A position that the push reaches in a part of the run [m].
  double way() { return dice_.between(0.01, 0.08) * duration_ * duration_ / mass_; }

  void take_force(Entry entry, const char* force) {
    forces_ += ", " + entry.name + force;
    bench_.add(std::move(entry));
  }

  void add_friction() {
    const std::string name = bench_.next_name();
    const double coulomb = dice_.between(0.1, 0.6);
    Entry entry{name,
                {{"block", "Friction"},
                 {"mass", own_mass()},
                 {"coulomb", number(coulomb, "N")},
                 {"force", others_},
                 {"velocity", body_ + ".velocity"}}};
    if (dice_.chance(0.6)) entry.keys.push_back({"breakaway", number(dice_.between(0.6, 0.9), "N")});
    if (dice_.chance(0.4)) entry.keys.push_back({"viscous", number(dice_.between(0.1, 1.0), "N s/m")});
    if (dice_.chance(0.4)) entry.keys.push_back({"stribeck", number(way() / duration_, "m/s")});
    take_force(std::move(entry), ".y");
    add_wire(bench_, name + ".y", "N");
    add_wire(bench_, name + ".slides", "");
  }

  /// Bristles that the step resolves.
  void add_bristles() {
    const std::string name = bench_.next_name();
    const double rate = dice_.between(0.03, 0.1) / bench_.step;
    take_force({name,
                {{"block", "LuGre"},
                 {"velocity", body_ + ".velocity"},
                 {"stiffness", number(mass_ * rate * rate, "N/m")},
                 {"damping", number(mass_ * rate * dice_.between(0.2, 1.0), "N s/m")},
                 {"coulomb", number(dice_.between(0.1, 0.4), "N")},
                 {"breakaway", number(dice_.between(0.4, 0.7), "N")},
                 {"stribeck", number(way() / duration_, "m/s")}}},
               "");
    add_wire(bench_, name, "N");
  }

  void add_dahl() {
    const std::string name = bench_.next_name();
    const double rate = dice_.between(0.03, 0.3) / bench_.step;
    take_force({name,
                {{"block", "Dahl"},
                 {"velocity", body_ + ".velocity"},
                 {"stiffness", number(mass_ * rate * rate, "N/m")},
                 {"coulomb", number(dice_.between(0.1, 0.5), "N")}}},
               "");
    add_wire(bench_, name, "N");
  }

  void add_stops() {
    const std::string name = stops_ = bench_.next_name();
    Entry entry{name,
                {{"block", "HardStop"},
                 {"mass", own_mass()},
                 {"force", others_},
                 {"position", body_ + ".position"},
                 {"velocity", body_ + ".velocity"},
                 {"lower", number(-way(), "m")},
                 {"restitution", number(dice_.between(0.0, 0.9), "1")}}};
    if (dice_.chance(0.6)) entry.keys.push_back({"upper", number(way(), "m")});
    entry.keys.push_back({"slow", number(0.02 * way() / duration_, "m/s")});
    take_force(std::move(entry), ".y");
    add_wire(bench_, name + ".y", "N");
    add_wire(bench_, name + ".hit", "");
    add_wire(bench_, name + ".rebound", "m/s");
    add_wire(bench_, name + ".rests", "");
  }

  void add_mass() {
    const std::string total = bench_.next_name();
    bench_.add({total, {{"block", "Sum"}, {"u", "[" + forces_ + "]"}}});
    Entry entry{body_, {{"block", "Mass"}, {"mass", own_mass()}, {"force", total}}};
    if (!stops_.empty()) {
      entry.keys.push_back({"reset", stops_ + ".hit"});
      entry.keys.push_back({"value", stops_ + ".rebound"});
    }
    bench_.add(std::move(entry));
    add_wire(bench_, total, "N");
    add_wire(bench_, body_ + ".position", "m");
    add_wire(bench_, body_ + ".velocity", "m/s");
  }

  Bench& bench_;
  Dice& dice_;
  double duration_, mass_ = 1.0;
  std::string push_, body_, spring_, others_, forces_, stops_;
};

const std::vector<std::vector<Key>>& crossings() {
  static const std::vector<std::vector<Key>> kinds{
      {{"block", "Compare"}, {"to", "0.3"}, {"operator", "greater"}},
      {{"block", "Relay"},
       {"switch_on", "0.4"},
       {"switch_off", "-0.2"},
       {"when_on", "0.7"},
       {"when_off", "-0.3"}},
      {{"block", "Saturation"}, {"lower", "-0.6"}, {"upper", "0.5"}},
      {{"block", "DeadZone"}, {"lower", "-0.3"}, {"upper", "0.4"}},
      {{"block", "Hysteresis"}, {"lower", "-0.3"}, {"upper", "0.35"}},
      {{"block", "Sign"}},
      {{"block", "Backlash"}, {"width", "0.4"}},
      {{"block", "EdgeDetect"}}};
  return kinds;
}

}  // namespace

void add_input(Bench& bench) {
  const unit::Dimension unit = bench.some_unit();
  const std::string value = Bench::plain(bench.signed_size(), unit);
  bench.sketch.inputs.push_back(
      {"in1", fmt::format("{{unit: \"{}\", default: {}, doc: of the outside}}", unit::si_name(unit), value)});
  bench.wires.push_back({"in1", {}, unit});
}

void add_crossing(Bench& bench) {
  const std::string wave = bench.next_name(), name = bench.next_name();
  const std::string rate = digits(bench.dice.between(1.5, 9.0) / (bench.step * bench.ticks));
  bench.add({wave, {{"block", "Sine"}, {"frequency", rate + " Hz"}}});
  add_wire(bench, wave, "");
  Entry entry{name, bench.dice.of(crossings())};
  entry.keys.push_back({"u", wave});
  bench.add(std::move(entry));
  add_wire(bench, name, "");
}

void add_bus(Bench& bench) {
  const std::string bus = bench.next_name(), store = bench.next_name();
  std::string fields;
  std::vector<Wire> kept;
  for (const char* field : {"a", "b", "c"}) {
    if (kept.size() == 2 && bench.dice.chance(0.5)) break;
    const Wire wire = bench.any_wire(true);
    fields += fmt::format("{}{}: {}", kept.empty() ? "" : ", ", field, wire.text);
    kept.push_back({store + "." + field, wire.shape, wire.unit});
  }
  bench.add({bus, {{"fields", "{" + fields + "}"}}});
  const char* type = bench.dice.chance(0.5) ? "UnitDelay" : "ZeroOrderHold";
  const std::string every = digits(bench.some_period()) + " s";
  bench.add({store, {{"block", type}, {"u", bus}, {"every", every}}});
  bench.wires.insert(bench.wires.end(), kept.begin(), kept.end());
}

void add_body(Bench& bench) {
  Body(bench).make();
}

void add_delayed_loop(Bench& bench) {
  const std::string rate = bench.next_name(), state = bench.next_name(), past = bench.next_name();
  const double duration = bench.step * bench.ticks;
  const std::string gain = Bench::plain(-bench.dice.between(2.0, 8.0) / duration, dimension_of("Hz"));
  bench.add({rate, {{"block", "Gain"}, {"u", past}, {"gain", gain}}});
  bench.add({state, {{"block", "Integrator"}, {"u", rate}, {"initial", digits(bench.signed_size())}}});
  const std::string delay =
      bench.smooth ? digits(bench.step * some_steps(bench, 6, 20)) + " s"
                   : bench.number(bench.step * bench.dice.between(1.0, 0.2 * bench.ticks), dimension_of("s"));
  bench.add({past,
             {{"block", "TransportDelay"},
              {"u", state},
              {"delay", delay},
              {"initial", digits(bench.signed_size())}}});
  for (const std::string& name : {state, past}) add_wire(bench, name, "");
}

}  // namespace stepwire::random
