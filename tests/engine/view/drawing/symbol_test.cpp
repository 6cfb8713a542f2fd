#include <catch2/catch.hpp>
#include <regex>

#include "blocks/register.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/view/drawing/symbol_text.hpp"

namespace stepwire::drawing {

namespace {

using Lines = std::vector<std::string>;

/// The text in the symbol of a block that is written as these keys.
Lines lines_of(const std::string& keys, bool* fraction = nullptr) {
  const Registry registry = blocks();
  diagram::Loader loader(registry);
  const std::string head =
      "stepwire: 1\nstep: 1 ms\nstop: 1 s\nsolver: rk4\nparameters: {tau: 2, k: 3, long_name: 1}\n";
  const std::string text =
      head + "blocks: {a: {" + keys + "}, others: {block: Constant, value: [$tau, $k, $long_name]}}\n";
  const diagram::Diagram diagram = loader.load_text(text, "a.yaml");
  const yaml::Document document = yaml::parse_document(text, "a.yaml");
  const SymbolText found = symbol_text(diagram.blocks[0], document.root.find("blocks")->entries[0].value);
  if (fraction) *fraction = found.fraction;
  return found.lines;
}

}  // namespace

TEST_CASE("every symbol names parameters of its block and draws in its square") {
  const Registry registry = blocks();
  const std::regex place(R"(\{([a-z_0-9]+)(:[sz])?(\|[^}]*)?\})", std::regex::icase);
  const std::regex command(R"([MLHVCZ]|-?(?:\d+\.?\d*|\.\d+)| )");
  for (const BlockType* type : registry.types()) {
    INFO(type->name);
    const Symbol& symbol = type->symbol;
    for (std::sregex_iterator at(symbol.text.begin(), symbol.text.end(), place), end; at != end; ++at)
      CHECK(type->parameter((*at)[1].str()) != nullptr);
    CHECK(std::regex_replace(symbol.text, place, "").find_first_of("{}") == std::string::npos);
    CHECK(std::regex_replace(symbol.curve, command, "").empty());
    if (!symbol.signs.empty()) CHECK(type->parameter(symbol.signs) != nullptr);
  }
}

TEST_CASE("a gain shows its value as the file gives it, and a letter where that is long") {
  CHECK(lines_of("block: Gain, u: 1, gain: 2 N/mm") == Lines{"2 N/mm"});
  CHECK(lines_of("block: Gain, u: 1, gain: -2.5") == Lines{"−2.5"});
  CHECK(lines_of("block: Gain, u: 1, gain: $tau") == Lines{"τ"});
  CHECK(lines_of("block: Gain, u: 1, gain: = 2*pi/k^2") == Lines{"2·π/k²"});
  CHECK(lines_of("block: Gain, u: 1, gain: = 2*long_name*3*long_name") == Lines{"K"});
  CHECK(lines_of("block: Gain, u: 1") == Lines{"1"});
}

TEST_CASE("a transfer function is a fraction of polynomials in SI") {
  bool fraction = false;
  CHECK(lines_of("block: TransferFunction, u: 1, numerator: [-3, 0], denominator: [1, 0.5, -25]",
                 &fraction) == Lines{"−3 s", "s² + 0.5 s − 25"});
  CHECK(fraction);
  CHECK(lines_of("block: Lag, u: 1, tau: 20 ms") == Lines{"1", "0.02 s + 1"});
  CHECK(lines_of("block: Lag, u: 1, tau: $tau") == Lines{"1", "τ s + 1"});
  CHECK(lines_of("block: Lag, u: 1, tau: 1 s, gain: 1e-5") == Lines{"10⁻⁵", "s + 1"});
  CHECK(lines_of("block: Integrator, u: 1") == Lines{"1", "s"});
}

TEST_CASE("words and relations are typeset, and a block without symbol shows the words of its name") {
  CHECK(lines_of("block: Compare, u: 1, operator: \"<=\", to: 2") == Lines{"≤"});
  CHECK(lines_of("block: Compare, u: 1, operator: less, to: 2") == Lines{"<"});
  CHECK(lines_of("block: Expression, u: 1, expression: 2*u >= 3") == Lines{"2·u ≥ 3"});
  CHECK(lines_of("block: RotaryMRDamper, velocity: 0, current: 0") == Lines{"Rotary", "MR", "Damper"});
  CHECK(lines_of("block: PID, u: 1") == Lines{"PID"});
  CHECK(lines_of("block: Saturation, u: 1").empty());
}

}  // namespace stepwire::drawing
