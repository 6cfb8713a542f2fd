#include "engine/app/language/edits.hpp"

#include <catch2/catch.hpp>

#include "blocks/register.hpp"
#include "tests/engine/app/language/editing.hpp"

namespace stepwire::language {

using Catch::Matchers::Contains;

namespace {

const std::string spring =
    "stepwire: 1\ntitle: a spring\ninputs: {x: {unit: m}}\noutputs: {force: k}\nparameters: {c: 2 N/m}\n"
    "blocks:\n  k: {block: Gain, gain: $c, u: x}\n";
const std::string cart = "# \u03a9 \U0001f600 cart\n" + file_head +
                         "parameters:\n  mass: 2 kg\n  rate: {value: 3 N/m, doc: of the spring}\n"
                         "record: [cart.position, rig.force, turned]\n"
                         "figure: {plot: lines, x: time, y: [cart.position in mm], \"y_label\": \"cart\"}\n"
                         "blocks:\n"
                         "  held: {block: Gain, gain: $rate, u: cart.position}\n"
                         "  rig: {diagram: spring.yaml, x: cart.position}  # held\n"
                         "  turned: {block: Gain, gain: -1, u: rig}\n"
                         "  cart: {block: Mass, mass: $mass, force: turned, initial_position: 1 m}\n";

struct Cart : Editing {
  Cart() {
    write("spring.yaml", spring);
    open("a.yaml", cart);
  }
  std::string after(const Edit& edit) { return edited("a.yaml", edit).at("a.yaml"); }
  std::string refusal(const Edit& edit) {
    try {
      edited("a.yaml", edit);
    } catch (const EditRefused& refused) {
      return refused.what();
    }
    return "";
  }
};

std::string with(const std::string& old_piece, const std::string& new_piece) {
  const std::size_t at = cart.find(old_piece);
  REQUIRE(at != std::string::npos);
  return cart.substr(0, at) + new_piece + cart.substr(at + old_piece.size());
}

bool offers(const std::vector<InputName>& all, const InputName& one) {
  return std::ranges::find(all, one) != all.end();
}

}  // namespace

TEST_CASE("a number is set by its name wherever the file has it, or where its default stood for it") {
  Cart files;
  REQUIRE(files.wrong("a.yaml").empty());
  CHECK(files.after(SetValue{"turned.gain", "-2"}) == with("gain: -1", "gain: -2"));
  CHECK(files.after(SetValue{"mass", "8 kg"}) == with("mass: 2 kg", "mass: 8 kg"));
  CHECK(files.after(SetValue{"rate", "4 N/m"}) == with("value: 3 N/m", "value: 4 N/m"));
  CHECK(files.after(SetValue{"stop", "2 s"}) == with("stop: 1 s", "stop: 2 s"));
  CHECK(files.after(SetValue{"rig.c", "$rate"}) == with("x: cart.position}", "x: cart.position, c: $rate}"));
  CHECK(files.after(SetValueAt{std::string("# 1 34 cart\n").size() + file_head.size() + 22, "9 kg"}) ==
        with("mass: 2 kg", "mass: 9 kg"));
  CHECK_THAT(files.refusal(SetValue{"rig.k.gain", "1"}), Contains("no 'k.gain' in this file"));
  CHECK_THAT(files.refusal(SetValue{"nothing", "1"}), Contains("no 'nothing'"));
}

TEST_CASE("an element of a list is set by its number") {
  Cart files;
  files.open("b.yaml", file_head + "blocks:\n  a: {block: Constant, value: [1, 2 , 3]}\n");
  CHECK_THAT(files.edited("b.yaml", SetValue{"a.value.2", "5"}).at("b.yaml"), Contains("[1, 5 , 3]"));
  CHECK_THROWS_AS(files.edited("b.yaml", SetValue{"a.value.4", "5"}), EditRefused);
}

TEST_CASE("a block is renamed by its name with every use") {
  Cart files;
  const std::string text = files.after(Rename{"cart", "trolley"});
  CHECK_THAT(text, Contains("record: [trolley.position") && Contains("x: trolley.position}") &&
                       Contains("  trolley: {block") && Contains("[trolley.position in mm]") &&
                       Contains("\"y_label\": \"cart\""));
  CHECK_THAT(files.refusal(Rename{"cart", "rig"}), Contains("already"));
}

TEST_CASE("a wire is put where units fit, and refused where they do not") {
  Cart files;
  CHECK(files.after(Connect{"rig.force", "cart", "force"}) == with("force: turned", "force: rig"));
  CHECK(files.refusal(Connect{"cart.position", "cart", "force"}) ==
        "'cart.position' is in m, and 'cart.force' takes N");
  CHECK_THAT(files.refusal(Connect{"cart.nothing", "cart", "force"}), Contains("nothing"));
  // The input itself takes any unit, but not so what follows from it.
  files.open("a.yaml", with("force: turned", "force: held"));
  CHECK_THAT(files.refusal(Connect{"cart.velocity", "held", "u"}),
             Contains("cart.force") && !Contains("a.yaml"));
  files.open("a.yaml", cart);
  CHECK_THAT(files.refusal(Connect{"cart.position", "ghost", "u"}), Contains("no block 'ghost'"));
  CHECK(files.after(Disconnect{"turned", "u"}) == with(", u: rig}", "}"));
  const auto fitting = files.service().inputs_for(files.path("a.yaml"), "cart.position");
  CHECK(offers(fitting, {"rig", "x"}));
  CHECK(offers(fitting, {"turned", "u"}));
  CHECK_FALSE(offers(fitting, {"cart", "force"}));
}

TEST_CASE("a wire is refused where sizes do not fit") {
  Cart files;
  const std::string text = file_head +
                           "blocks:\n  two: {block: Constant, value: [1, 2]}\n"
                           "  three: {block: Constant, value: [1, 2, 3]}\n"
                           "  turned: {block: MatrixGain, gain: [[0, 1], [1, 0]], u: two}\n"
                           "  free: {block: Gain, gain: 2}\n  lag: {block: Lag, tau: 1 s, u: turned}\n";
  files.open("b.yaml", text);
  const auto refusal = [&](const Connect& edit) {
    try {
      files.edited("b.yaml", edit);
    } catch (const EditRefused& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(refusal({"three", "turned", "u"}), Contains("'three' has 3 elements, but turned.u takes 2"));
  CHECK(refusal({"three", "lag", "u"}).empty());
  CHECK(refusal({"three", "free", "u"}).empty());
  const auto fitting = files.service().inputs_for(files.path("b.yaml"), "three");
  CHECK(offers(fitting, {"free", "u"}));
  CHECK(offers(fitting, {"lag", "u"}));
  CHECK_FALSE(offers(fitting, {"turned", "u"}));
}

TEST_CASE("a refused wire names its own input first, wherever its unit does not fit") {
  Cart files;
  files.open("b.yaml", file_head +
                           "blocks:\n  room: {block: Constant, value: 20 degC}\n"
                           "  want: {block: Step, time: 0.2 s, after: 600 rpm}\n"
                           "  e: {block: Sum, signs: \"+-\", u: [want, motor]}\n"
                           "  pi: {block: PID, u: e, kp: 2, ki: 10 1/s}\n"
                           "  motor: {block: Lag, u: pi, tau: 200 ms}\n"
                           "  turn: {block: Integrator, u: motor, initial: 0 deg}\n");
  for (const char* input : {"u.1", "u.2"}) {
    try {
      files.edited("b.yaml", Connect{"room", "e", input});
      FAIL("not refused");
    } catch (const EditRefused& error) {
      CHECK_THAT(error.what(), Catch::StartsWith("e.u") && Contains("K") && Contains("rad/s"));
    }
  }
}

TEST_CASE("a list of signals grows, and one of them is replaced") {
  Cart files;
  const std::string head =
      file_head + "blocks:\n  a: {block: Constant, value: 1}\n  b: {block: Constant, value: 2}\n";
  files.open("b.yaml", head + "  max: {block: MinMax, u: [a, b]}\n");
  const auto after = [&](const Edit& edit) { return files.edited("b.yaml", edit).at("b.yaml"); };
  CHECK(after(Connect{"a", "max", "u.2"}) == head + "  max: {block: MinMax, u: [a, a]}\n");
  CHECK(after(Connect{"a.y", "max", "u.3"}) == head + "  max: {block: MinMax, u: [a, b, a]}\n");
  CHECK(after(Disconnect{"max", "u.1"}) == head + "  max: {block: MinMax, u: [b]}\n");
  CHECK_THROWS_AS(after(Connect{"a", "max", "u.5"}), EditRefused);
}

TEST_CASE("a part's output is given another signal, and its input is one") {
  Editing files;
  files.open("spring.yaml", spring);
  const std::string text = files.edited("spring.yaml", Connect{".x", "k", "u"}).empty()
                               ? ""
                               : files.edited("spring.yaml", Connect{"x", "", "force"}).at("spring.yaml");
  CHECK_THAT(text, Contains("outputs: {force: x}"));
}

TEST_CASE("a block is deleted with its line, its names in lists go, and what else names it is a fault") {
  Cart files;
  const EditChanges changes = files.service().edited(files.path("a.yaml"), Remove{"cart"});
  REQUIRE_FALSE(changes.faults.empty());
  const std::string text = files.after(Remove{"cart"});
  CHECK_THAT(text, Contains("record: [rig.force, turned]") && !Contains("  cart: {") &&
                       Contains("x: cart.position}  # held"));
  CHECK_THAT(files.after(Remove{"rig"}), !Contains("# held") && Contains("record: [cart.position, turned]"));
  CHECK_THAT(files.after(Remove{"mass"}), !Contains("mass: 2 kg") && Contains("mass: $mass"));
}

TEST_CASE("a block is inserted with what feeds it in one edit, or not at all where a wire does not fit") {
  Cart files;
  CHECK_THAT(files.after(Insert{"Gain", "twice", {{"u", "cart.position"}}}),
             Contains("  twice: {block: Gain") && Contains("u: cart.position}\n"));
  CHECK_THAT(files.after(Insert{"MinMax", "most", {{"u.1", "held"}, {"u.2", "rig.force"}}}),
             Contains("u: [held, rig]"));
  CHECK_THAT(files.after(Insert{"spring.yaml", "second", {{"x", "cart.position"}}}),
             Contains("  second: {diagram: spring.yaml, x: cart.position}\n"));
  CHECK_THAT(files.refusal(Insert{"Mass", "second", {{"force", "cart.position"}}}), Contains("force"));
  CHECK_THAT(files.refusal(Insert{"Gain", "twice", {{"v", "held"}}}), Contains("Gain has no input 'v'"));
  CHECK_THAT(files.refusal(Insert{"Gain", "twice", {{"u", "nothing"}}}), Contains("no signal 'nothing'"));
  CHECK_THAT(files.refusal(Insert{"spring.yaml", "second", {{"z", "held"}}}), Contains("z"));
  // One of two inputs: the block is not whole yet, but the wire is right.
  CHECK_THAT(files.after(Insert{"Atan2", "angle", {{"adjacent", "held"}}}), Contains("adjacent: held"));
  const std::string text =
      R"({"kind": "insert", "type": "Gain", "inputs": [{"input": "u", "from": "held"}]})";
  CHECK_THAT(files.after(edit_of(json::Json::parse(text))), Contains("u: held}"));
}

TEST_CASE("a block of any kind is inserted with a free name and what it requires") {
  Cart files;
  const Registry registry = blocks();
  for (const BlockType* type : registry.types()) {
    INFO(type->name);
    const EditChanges changes = files.service().edited(files.path("a.yaml"), Insert{type->name, ""});
    CHECK_FALSE(changes.name.empty());
    const std::string text = files.after(Insert{type->name, ""});
    CHECK_THAT(text, Contains("\n  " + changes.name + ": {block: " + type->name));
    for (const ParameterSpec& parameter : type->parameters)
      if (parameter.required) CHECK_THAT(text, Contains(parameter.name + ": "));
  }
  CHECK(files.service().edited(files.path("a.yaml"), Insert{"Mass", "cart_2"}).name == "cart_2");
  CHECK_THAT(files.refusal(Insert{"Mass", "cart"}), Contains("taken"));
  CHECK_THAT(files.refusal(Insert{"Nothing", ""}), Contains("no block 'Nothing'"));
  CHECK_THAT(files.after(Insert{"spring.yaml", ""}), Contains("  spring: {diagram: spring.yaml}\n"));
}

TEST_CASE("a block is inserted in lines where the others are in lines, and as the first one") {
  Cart files;
  files.open("b.yaml", file_head + "blocks:\r\n    lag:\r\n      block: TransferFunction\r\n      u: 1\r\n");
  const auto after = [&](const std::string& name, const Edit& edit) {
    return files.edited(name, edit).at(name);
  };
  CHECK(after("b.yaml", Insert{"Lag", ""}) == files.text("b.yaml") + "    lag_2:\r\n      block: Lag\r\n");
  files.open("c.yaml", file_head + "blocks:\n");
  CHECK(after("c.yaml", Insert{"Lag", "x"}) == file_head + "blocks: {x: {block: Lag}}\n");
  files.open("d.yaml", file_head);
  CHECK_THAT(after("d.yaml", Insert{"Lag", "x"}), Contains("solver: rk4\nblocks: {x: {block: Lag"));
}

TEST_CASE("edits come as JSON, and what is none is refused") {
  const auto edit = [](const char* text) { return edit_of(json::Json::parse(text)); };
  CHECK(std::get<SetValue>(edit(R"({"kind": "number", "name": "a.b", "text": "8 kg"})")).text == "8 kg");
  CHECK(std::get<SetValueAt>(edit(R"({"kind": "word", "at": 7, "text": "x"})")).offset == 7);
  CHECK(std::get<Connect>(edit(R"({"kind": "connect", "from": "a", "to": "b", "input": "u"})")).input == "u");
  CHECK(std::get<Insert>(edit(R"({"kind": "insert", "type": "Lag"})")).name.empty());
  CHECK(std::get<Remove>(edit(R"({"kind": "delete", "name": "a"})")).name == "a");
  CHECK(std::get<AddItem>(edit(R"({"kind": "item", "section": "claims", "text": "{}"})")).section ==
        "claims");
  CHECK(std::get<CutLoop>(edit(R"({"kind": "bode", "signal": "a.y"})")).at.empty());
  for (const char* wrong :
       {"{}", "[]", "3", R"({"kind": "explode"})", R"({"kind": "delete"})",
        R"({"kind": "number", "at": -1, "text": "x"})", R"({"kind": "rename", "name": 3, "to": "x"})"})
    CHECK_THROWS_AS(edit(wrong), EditRefused);
}

TEST_CASE("shapes of a drawing have their places in the text, in UTF-16, also inside of parts") {
  Cart files;
  const auto shapes = files.service().shapes(files.path("a.yaml"));
  const auto piece = [&](const std::string& name) {
    const Utf16Range& range = shapes.at(name);
    const std::string& text = files.text(range.file.substr(files.path("").size()));
    const Utf16Places places(text);
    return text.substr(places.offset(range.from), places.offset(range.to) - places.offset(range.from));
  };
  CHECK(piece("turned") == "turned: {block: Gain, gain: -1, u: rig}");
  CHECK(piece("turned.u") == "u: rig");
  CHECK(piece("cart.position") == "cart");
  CHECK(piece("rig.x") == "x: cart.position");
  CHECK(piece("rig.force") == "rig");
  CHECK(piece("rig.k") == "k: {block: Gain, gain: $c, u: x}");
  CHECK(piece("rig.k.u") == "u: x");
  CHECK(shapes.at("turned").from + 3 ==
        cart.find("turned: {"));  // two letters of four and two bytes before it
}

TEST_CASE("places in UTF-16 and in bytes lead to one another in long texts") {
  std::string text;
  for (int i = 0; i < 400; ++i) text += i % 7 == 0 ? "\U0001f600" : i % 3 == 0 ? "\u03a9" : "a";
  const Utf16Places places(text);
  std::size_t units = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto byte = static_cast<unsigned char>(text[at]);
    if ((byte & 0xc0) == 0x80) continue;
    CHECK(places.units(at) == units);
    CHECK(places.offset(units) == at);
    units += byte >= 0xf0 ? 2 : 1;
  }
  CHECK(places.units(text.size()) == units);
  CHECK(places.offset(units + 9) == text.size());
}

}  // namespace stepwire::language
