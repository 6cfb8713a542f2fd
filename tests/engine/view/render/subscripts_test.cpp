#include "engine/view/render/picture.hpp"

#include <catch2/catch.hpp>

namespace stepwire::render {
namespace {

const std::string small = "<tspan dy=\"3\" font-size=\"0.75em\">",
                  back = "<tspan dy=\"-3\" xml:space=\"preserve\">", end = "</tspan>";

TEST_CASE("the index of a quantity stands below the line, and the text behind it on the line") {
  CHECK(with_subscripts("F_max") == "F" + small + "max" + end);
  CHECK(with_subscripts("force F_e [N]") == "force F" + small + "e" + end + back + " [N]" + end);
  CHECK(with_subscripts("V_gp &gt; HV_gp") ==
        "V" + small + "gp" + end + back + " &gt; HV" + small + "gp" + end + end);
  CHECK(with_subscripts("|F_x|") == "|F" + small + "x" + end + back + "|" + end);
}

TEST_CASE("names of blocks, files and numbers keep their underscores") {
  for (const char* name : {"joint_force", "law_1.f_max", "mean.V_gp", "F_max.1", "F_force", "Ab_c", "f_r",
                           "F_", "_e", "A_b_c", "plain"})
    CHECK(with_subscripts(name) == name);
}

TEST_CASE("texts of a picture get indices, other elements stay") {
  std::string svg = "<g id=\"F_e\"><text>F_e</text><text>no_index</text><title>F_e</title></g>";
  set_subscripts(svg);
  CHECK(svg ==
        "<g id=\"F_e\"><text>F" + small + "e" + end + "</text><text>no_index</text><title>F_e</title></g>");
}

}  // namespace
}  // namespace stepwire::render
