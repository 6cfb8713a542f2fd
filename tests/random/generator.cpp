#include "tests/random/generator.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tests/random/making.hpp"
#include "tests/random/reshaping.hpp"
#include "tests/random/rigs.hpp"
#include "tests/random/smooth.hpp"

namespace stepwire::random {

namespace {

const std::vector<std::string>& fixed_solvers() {
  static const std::vector<std::string> solvers{
      "euler", "heun", "bogacki_shampine", "rk4", "dormand_prince", "rosenbrock", "sdirk"};
  return solvers;
}

const std::vector<std::string>& controlled_solvers() {
  static const std::vector<std::string> solvers{
      "dormand_prince", "bogacki_shampine", "rodas", "rosenbrock", "sdirk", "auto"};
  return solvers;
}

/// Makes a whole diagram on a bench.
class Generator {
 public:
  Generator(const Registry& registry, std::uint64_t seed) : bench_(seed), dice_(bench_.dice), seed_(seed) {
    bench_.smooth = is_smooth(seed);
    bench_.continuous = is_continuous(seed);
    for (const BlockType* type : registry.types())
      if (!type->file_output && is_allowed(type->name)) types_.push_back(type);
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
  bool is_allowed(const std::string& type) const {
    if (bench_.continuous) return may_be_continuous(type);
    return !bench_.smooth || may_be_smooth(type);
  }

  void choose_times() {
    bench_.step = dice_.of(std::vector<double>{1e-4, 1e-3, 1e-3, 2e-3, 5e-3, 1e-2});
    bench_.ticks = dice_.whole(50, 300);
    if (dice_.chance(0.15)) bench_.ticks = dice_.whole(300, 500);
    bench_.locates = dice_.chance(0.5);
    bench_.solves_loops = dice_.chance(0.2);
    bench_.guards = dice_.chance(0.35);
    if (!bench_.smooth) return;
    bench_.ticks = dice_.whole(15, 35) * 2;
    bench_.solves_loops = false;
    if (bench_.continuous) bench_.guards = false;
  }

  /// The first type is another one for each seed, so that each comes up.
  void add_blocks() {
    const int wanted = dice_.chance(0.6) ? dice_.whole(3, 12) : dice_.whole(12, 25);
    for (int i = 0; i < 2; ++i) bench_.wires.push_back(bench_.wire({}));
    bench_.wires.resize(bench_.wires.size() - 2);
    if (bench_.locates && !bench_.smooth) add_crossing(bench_);
    if (dice_.chance(0.15)) add_input(bench_);
    add(bench_.smooth ? *chosen_type() : *types_[rank_among_others(seed_) % types_.size()]);
    while (static_cast<int>(bench_.sketch.blocks.size()) < wanted) add_more();
  }

  void add_more() {
    if (!bench_.continuous && dice_.chance(0.06)) return add_bus(bench_);
    if (!bench_.continuous && dice_.chance(0.04)) return add_rig(add_delayed_loop);
    if (!bench_.smooth && dice_.chance(0.05)) return add_rig(add_body);
    add(*chosen_type());
  }

  void add_rig(void (*add_it)(Bench& bench)) {
    add_it(bench_);
    is_continuous_ = true;
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
    if (bench_.smooth || dice_.chance(0.6)) return dice_.of(fixed_solvers());
    if (dice_.chance(0.2)) return "auto";
    std::string keys = "name: " + dice_.of(controlled_solvers());
    if (dice_.chance(0.8)) keys += fmt::format(", relative: {}", digits(power_of_ten(-9.0, -2.0)));
    if (dice_.chance(0.6)) keys += fmt::format(", absolute: {}", digits(power_of_ten(-12.0, -3.0)));
    if (dice_.chance(0.2)) keys += fmt::format(", max_steps: {}", dice_.whole(100, 20000));
    return "{" + keys + "}";
  }

  double power_of_ten(double lower, double upper) {
    return portable_exp(2.302585 * dice_.between(lower, upper));
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
    if (!bench_.smooth && dice_.chance(0.1))
      sketch.blocks.back().keys.push_back({"every", digits(bench_.some_period()) + " s"});
    if (bench_.smooth || !dice_.chance(0.3)) return;
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
