#include <catch2/catch.hpp>

#include "engine/model/block/registry.hpp"

namespace stepwire {
using Catch::Contains;

namespace {

/// A kind with the parameters `tau`, a number, and `roots`, a list, that is drawn like this.
BlockType drawn_as(Symbol symbol) {
  BlockType type;
  type.name = "Drawn";
  ParameterSpec tau, roots;
  tau.name = "tau";
  roots.name = "roots";
  roots.kind = ParameterKind::vector;
  type.parameters = {tau, roots};
  type.symbol = std::move(symbol);
  return type;
}

/// Returns the reason for which the registry refuses a symbol; empty if it accepts it.
std::string refusal_of(Symbol symbol) {
  Registry registry;
  try {
    registry.add(drawn_as(std::move(symbol)));
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a symbol may show any parameter of its block, as it is, shortened or as a polynomial") {
  CHECK(refusal_of({}) == "");
  CHECK(refusal_of({.text = "1 / {tau} s + 1"}) == "");
  CHECK(refusal_of({.text = "{tau|T}\n{roots:s|N(s)}"}) == "");
  CHECK(refusal_of({.signs = "tau"}) == "");
}

TEST_CASE("a symbol that names what its block does not have is refused before anything is drawn") {
  CHECK_THAT(refusal_of({.text = "z{-1}"}), Contains("Drawn") && Contains("no parameter '-1'"));
  CHECK_THAT(refusal_of({.text = "{taw|T}"}), Contains("no parameter 'taw'"));
  CHECK_THAT(refusal_of({.text = "{tau:s}"}), Contains("no list of coefficients"));
  CHECK_THAT(refusal_of({.signs = "sgn"}), Contains("'sgn'"));
  CHECK_THAT(refusal_of({.text = "{tau"}), Contains("brace"));
  CHECK_THAT(refusal_of({.text = "tau}"}), Contains("brace"));
}

}  // namespace stepwire
