#include "tests/random/generator.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tests/random/making.hpp"
#include "tests/random/reshaping.hpp"

namespace stepwire::random {

namespace {

/// Makes a whole diagram on a bench.
class Generator {
 public:
  Generator(const Registry& registry, std::uint64_t seed) : bench_(seed), dice_(bench_.dice), seed_(seed) {
    for (const BlockType* type : registry.types())
      if (!type->file_output) types_.push_back(type);
  }

  Sketch make() {
    choose_times();
    add_blocks();
    keep_promises();
    write_head();
    if (dice_.chance(0.3)) move_some_into_part("part", "part.yaml");
    if (dice_.chance(0.06)) move_some_into_part("outer", "outer.yaml");
    return std::move(bench_.sketch);
  }

 private:
  void choose_times() {
    bench_.step = dice_.of(std::vector<double>{1e-4, 1e-3, 1e-3, 2e-3, 5e-3, 1e-2});
    bench_.ticks = dice_.whole(50, 300);
    if (dice_.chance(0.15)) bench_.ticks = dice_.whole(300, 500);
    bench_.locates = dice_.chance(0.5);
    bench_.solves_loops = dice_.chance(0.2);
    bench_.guards = dice_.chance(0.35);
  }

  /// The first type is another one for each seed, so that each comes up.
  void add_blocks() {
    const int wanted = dice_.chance(0.6) ? dice_.whole(3, 12) : dice_.whole(12, 25);
    for (int i = 0; i < 2; ++i) bench_.wires.push_back(bench_.wire({}));
    bench_.wires.resize(bench_.wires.size() - 2);
    if (bench_.locates) add_crossing();
    if (dice_.chance(0.15)) add_input();
    add(*types_[seed_ % types_.size()]);
    while (static_cast<int>(bench_.sketch.blocks.size()) < wanted)
      if (dice_.chance(0.06))
        add_bus();
      else
        add(*chosen_type());
  }

  /// A port to the outside, which feeds its default.
  void add_input() {
    const unit::Dimension unit = bench_.some_unit();
    const std::string value = Bench::plain(bench_.signed_size(), unit);
    bench_.sketch.inputs.push_back({"in1", fmt::format("{{unit: \"{}\", default: {}, doc: of the outside}}",
                                                       unit::si_name(unit), value)});
    bench_.wires.push_back({"in1", {}, unit});
  }

  /// A block that begins to do something else a few times in the run.
  void add_crossing() {
    const std::string wave = bench_.next_name(), name = bench_.next_name();
    const std::string rate = digits(dice_.between(1.5, 9.0) / (bench_.step * bench_.ticks));
    bench_.add({wave, {{"block", "Sine"}, {"frequency", rate + " Hz"}}});
    bench_.wires.push_back({wave, {}, {}});
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
    Entry entry{name, dice_.of(kinds)};
    entry.keys.push_back({"u", wave});
    bench_.add(std::move(entry));
    bench_.wires.push_back({name, {}, {}});
  }

  /// Rare are blocks that no code can be made of, as no law about code holds beside them.
  const BlockType* chosen_type() {
    while (true) {
      const BlockType* type = dice_.of(types_);
      if (type->header.empty() && !dice_.chance(0.05)) continue;
      if (bench_.locates && type->crossings.empty() && dice_.chance(0.4)) continue;
      return type;
    }
  }

  void add(const BlockType& type) {
    Making(bench_, type).make();
    if (type.has_continuous_state()) is_continuous_ = true;
  }

  /// A bus of some signals and a block that passes it on.
  void add_bus() {
    const std::string bus = bench_.next_name(), store = bench_.next_name();
    std::string fields;
    std::vector<Wire> kept;
    for (const char* field : {"a", "b", "c"}) {
      if (kept.size() == 2 && dice_.chance(0.5)) break;
      const Wire wire = bench_.any_wire(true);
      fields += fmt::format("{}{}: {}", kept.empty() ? "" : ", ", field, wire.text);
      kept.push_back({store + "." + field, wire.shape, wire.unit});
    }
    bench_.add({bus, {{"fields", "{" + fields + "}"}}});
    const char* type = dice_.chance(0.5) ? "UnitDelay" : "ZeroOrderHold";
    const std::string every = digits(bench_.some_period()) + " s";
    bench_.add({store, {{"block", type}, {"u", bus}, {"every", every}}});
    bench_.wires.insert(bench_.wires.end(), kept.begin(), kept.end());
  }

  void keep_promises() {
    for (std::size_t i = 0; i < bench_.promises.size(); ++i) {
      const Promise promise = bench_.promises[i];
      const std::string source = source_for(promise);
      for (Entry& entry : bench_.sketch.blocks)
        change_words(entry, [&](const std::string& word) { return word == promise.text ? source : word; });
    }
  }

  /// A signal that feeds back: behind a Gain that takes its unit and is below 1.
  std::string source_for(const Promise& promise) {
    const Wire wire = bench_.wire(promise.shape);
    if (!promise.unit && !promise.gentle) return wire.text;
    const unit::Dimension unit = promise.unit ? *promise.unit / wire.unit : unit::Dimension{};
    const double gain = dice_.between(0.05, promise.gentle ? 0.3 : 0.9);
    const std::string name = bench_.next_name();
    bench_.add({name,
                {{"block", "Gain"},
                 {"u", wire.text},
                 {"gain", Bench::plain(dice_.chance(0.7) ? -gain : gain, unit)}}});
    return name;
  }

  void write_head() {
    std::vector<Key>& head = bench_.sketch.head;
    head.push_back({"step", digits(bench_.step) + " s"});
    head.push_back({"stop", fmt::format("{} s", bench_.step * bench_.ticks)});
    if (is_continuous_) head.push_back({"solver", solver()});
    if (bench_.locates) head.push_back({"events", "locate"});
    if (bench_.solves_loops) head.push_back({"algebraic_loops", "solve"});
    if (dice_.chance(0.06))
      head.push_back(
          {"stop_when", fmt::format("{} > {}", bench_.wire({}).text, digits(dice_.between(0.5, 2.0)))});
    head.push_back({"record", records()});
  }

  std::string solver() {
    static const std::vector<std::string> solvers{
        "euler", "heun", "bogacki_shampine", "rk4", "dormand_prince", "rosenbrock", "sdirk"};
    return dice_.of(solvers);
  }

  std::string records() {
    std::string all = "all";
    dice_.shuffle(bench_.states);
    for (std::size_t i = 0; i < std::min<std::size_t>(bench_.states.size(), 3); ++i)
      all += ", " + bench_.states[i];
    if (dice_.chance(0.7)) return "[" + all + "]";
    return fmt::format("[{{signals: [{}]}}, {{every: {} s, signals: [{}]}}]", all,
                       digits(bench_.some_period()), bench_.wire({}).text);
  }

  /// Blocks that follow each other in the file become a part, which sometimes runs on condition.
  void move_some_into_part(const std::string& name, const std::string& file) {
    Sketch& sketch = bench_.sketch;
    const std::size_t count = sketch.blocks.size(), first = dice_.below(count);
    const std::size_t end = std::min(count, first + 1 + dice_.below(6));
    std::set<std::string> moved;
    for (std::size_t i = first; i < end; ++i) moved.insert(sketch.blocks[i].name);
    sketch = with_part(sketch, moved, name, file);
    if (moved.empty()) return;
    if (dice_.chance(0.1))
      sketch.blocks.back().keys.push_back({"every", digits(bench_.some_period()) + " s"});
    if (!dice_.chance(0.3)) return;
    const Entry& source = sketch.blocks.front();
    if (source.name == name || !source.find("block") || source.find("u")) return;
    for (Entry& entry : sketch.blocks)
      if (entry.name == name)
        entry.keys.push_back(
            {"enable", fmt::format("{{when: \"{} > {}\", states: {}}}", source.name,
                                   digits(dice_.between(-0.5, 0.5)), dice_.chance(0.5) ? "reset" : "held")});
  }

  Bench bench_;
  Dice& dice_;
  std::uint64_t seed_;
  std::vector<const BlockType*> types_;
  bool is_continuous_ = false;
};

}  // namespace

Sketch random_sketch(const Registry& registry, std::uint64_t seed) {
  return Generator(registry, seed).make();
}

}  // namespace stepwire::random
