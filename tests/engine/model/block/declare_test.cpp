#include <catch2/catch.hpp>

#include "engine/model/block/declare.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire {

namespace {

struct Everything {
  enum class Mode { slow, fast };
  double tau = 0.5;
  Mode mode = Mode::fast;
  std::int64_t count = 3;
  Input<> u{};
  Output<> y{};
  Output<1> out_{};
  State<> x{};
  DiscreteState<2> memory{};

  void outputs() { y = x; }
  void derivatives() {
    for (Index i = 0; i < x.size(); ++i) x.derivative[i] = (u[i] - x[i]) / tau;
  }

  static void declare(Declare<Everything>& is) {
    is.block("Everything", {.doc = "a test"});
    is.parameter<&Everything::tau>({.unit = "s", .doc = "time constant", .above = 0.0});
    is.parameter<&Everything::mode>({.doc = "pace", .words = {"slow", "fast"}});
    is.parameter<&Everything::count>({.doc = "how many"});
    is.input<&Everything::u>({.doc = "signal", .feedthrough = false});
    is.output<&Everything::y>({.doc = "state"});
    is.output<&Everything::out_>({.doc = "one number"});
    is.state<&Everything::x>({.doc = "state"});
    is.state<&Everything::memory>({.doc = "memory", .initial = 4.0});
  }
};

struct Plain {
  Input<> u{};
  void update() {}
  static void declare(Declare<Plain>& is) {
    is.block("Plain", {.doc = "a test", .not_real_time = "it waits"});
    is.input<&Plain::u>({.doc = "signal"});
  }
};

BlockType everything() {
  Declare<Everything> declaration;
  Everything::declare(declaration);
  return declaration.take();
}

}  // namespace

TEST_CASE("names, kinds and defaults of a block come from its members") {
  const BlockType type = everything();
  REQUIRE(type.parameter("tau"));
  CHECK(type.parameter("tau")->kind == ParameterKind::number);
  CHECK(type.parameter("mode")->kind == ParameterKind::word);
  CHECK(type.parameter("count")->kind == ParameterKind::integer);
  CHECK(type.parameter("nothing") == nullptr);
  const AnyBlock block(type);
  CHECK(std::get<double>(type.parameter("tau")->get(block.get()).content) == 0.5);
  CHECK(std::get<double>(type.parameter("mode")->get(block.get()).content) == 1.0);
  CHECK(type.output("out") == 1);  // the last '_' keeps a member's name apart from another's
  CHECK(type.output("out_") == -1);
}

TEST_CASE("phases, timing and shapes of a block come from what it has") {
  const BlockType type = everything();
  CHECK((type.run_outputs && type.run_derivatives && !type.run_update && !type.configure && !type.start));
  CHECK(type.timing == Timing::continuous);
  CHECK(type.has_continuous_state());
  CHECK(type.inputs[0].shape == "n");
  CHECK(type.outputs[1].shape == "1");
  CHECK(type.states[1].shape == "2");
  CHECK(type.states[1].initial == 4.0);
}

TEST_CASE("a block is fit for a real-time loop unless its declaration says why not") {
  Declare<Plain> plain;
  Plain::declare(plain);
  CHECK(everything().not_real_time.empty());
  CHECK(plain.take().not_real_time == "it waits");
}

TEST_CASE("a copy of a block has its parameters, and a place of its own") {
  const BlockType type = everything();
  AnyBlock first(type);
  type.parameter("tau")->set(first.get(), {2.0});
  AnyBlock copy(first);
  type.parameter("tau")->set(first.get(), {3.0});
  CHECK(static_cast<Everything*>(copy.get())->tau == 2.0);
  first = copy;
  CHECK(static_cast<Everything*>(first.get())->tau == 2.0);
}

TEST_CASE("a kernel runs its phase for blocks that lie side by side") {
  const BlockType type = everything();
  Everything blocks[2];
  double numbers[6] = {1.0, 2.0, 10.0, 20.0, 0.0, 0.0};
  for (int i = 0; i < 2; ++i) {
    blocks[i].u.bind(numbers + i, 1);
    blocks[i].x.bind(numbers + 2 + i, 1);
    blocks[i].x.derivative.bind(numbers + 4 + i, 1);
  }
  type.run_derivatives[Specialization::nothing](blocks, blocks + 2);
  CHECK(numbers[4] == (1.0 - 10.0) / 0.5);
  CHECK(numbers[5] == (2.0 - 20.0) / 0.5);
}

TEST_CASE("a registry finds its kinds by name and takes each name once") {
  Registry registry;
  registry.add<Everything>("test");
  registry.add<Plain>("test");
  CHECK(registry.names() == std::vector<std::string>{"Everything", "Plain"});
  CHECK(registry.find("Plain")->folder == "test");
  CHECK(registry.find("plain") == nullptr);
  CHECK_THROWS_AS(registry.add<Plain>("again"), std::logic_error);
}

}  // namespace stepwire
