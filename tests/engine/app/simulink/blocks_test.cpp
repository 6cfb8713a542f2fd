// Each translated type in a model of its own, whose run has a closed form.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/engine/app/simulink/slx.hpp"

using Catch::Contains;

namespace stepwire::simulink {

namespace {

const double pi = std::numbers::pi;

Approx near(double value) {
  return Approx(value).epsilon(1e-9).margin(1e-12);
}

}  // namespace

TEST_CASE("sources of Simulink have their values and defaults") {
  CHECK(from_source(number(1, "2*3 - 1/4")) == near(5.75));
  CHECK(from_source(block("Step", "Step", 1), "0.99") == near(0.0));
  CHECK(from_source(block("Step", "Step", 1), "1") == near(1.0));
  CHECK(from_source(block("Step", "Step", 1, {{"Time", "0.5"}, {"Before", "-1"}, {"After", "4"}}), "0.7") ==
        near(4.0));
  CHECK(from_source(
            reference("simulink/Sources/Ramp", "Ramp", 1, {{"slope", "2"}, {"start", "1"}, {"X0", "0.5"}}),
            "3") == near(4.5));
  CHECK(from_source(block("Sin", "Sine Wave", 1,
                          {{"Amplitude", "2"}, {"Frequency", "3"}, {"Phase", "0.5"}, {"Bias", "1"}}),
                    "2") == near(2.0 * std::sin(6.5) + 1.0));
  CHECK(from_source(
            block("Sin", "Sine", 1,
                  {{"SineType", "Sample based"}, {"Samples", "8"}, {"Offset", "1"}, {"SampleTime", "0.1"}}),
            "0.5") == near(std::sin(2.0 * pi * 6.0 / 8.0)));
  const P pulse{{"PulseType", "Time based"},
                {"Amplitude", "3"},
                {"Period", "2"},
                {"PulseWidth", "25"},
                {"PhaseDelay", "0.5"}};
  CHECK(from_source(block("DiscretePulseGenerator", "Pulse", 1, pulse), "0.9") == near(3.0));
  CHECK(from_source(block("DiscretePulseGenerator", "Pulse", 1, pulse), "1.2") == near(0.0));
  CHECK(from_source(block("Clock", "Clock", 1), "0.75") == near(0.75));
  CHECK(from_source(block("SignalGenerator", "Generator", 1, {{"Frequency", "2"}, {"Units", "rad/sec"}})) ==
        near(std::sin(2.0)));
  CHECK(from_source(reference("simulink/Sources/Chirp\nSignal", "Chirp", 1,
                              {{"f1", "0.1"}, {"T", "10"}, {"f2", "1"}}),
                    "5") == near(std::sin(2.0 * pi * (0.1 * 5.0 + 0.9 / 20.0 * 25.0))));
  CHECK(from_source(reference("simulink/Sources/Repeating\nSequence", "Saw", 1,
                              {{"rep_seq_t", "[0 1 2]"}, {"rep_seq_y", "[0 4 0]"}}),
                    "2.5") == near(2.0));
}

TEST_CASE("sums, gains and products follow their signs") {
  const std::vector<std::string> three{number(1, "7"), number(2, "2"), number(3, "4")};
  CHECK(through(block("Sum", "Sum", 9, {{"Inputs", "|+-+"}}), three) == near(9.0));
  CHECK(through(block("Sum", "Sum", 9, {{"Inputs", "3"}}), three) == near(13.0));
  CHECK(through(block("Sum", "Sum of Elements", 9, {{"Inputs", "-"}}), {number(1, "[1 2 3]")}) == near(-6.0));
  CHECK(through(block("Product", "Product", 9, {{"Inputs", "3"}}), three) == near(56.0));
  CHECK(through(block("Product", "Divide", 9, {{"Inputs", "*//"}}), three) == near(0.875));
  CHECK(through(block("Product", "Divide", 9, {{"Inputs", "/*"}}), {number(1, "4"), number(2, "2")}) ==
        near(0.5));
  CHECK(through(block("Gain", "Gain", 9, {{"Gain", "-2.5"}}), {number(1, "4")}) == near(-10.0));
  CHECK(through(block("Bias", "Bias", 9, {{"Bias", "0.5"}}), {number(1, "4")}) == near(4.5));
  CHECK(through(block("UnaryMinus", "Minus", 9), {number(1, "4")}) == near(-4.0));
  CHECK(through(block("DotProduct", "Dot", 9), {number(1, "[1 2 3]"), number(2, "[4 5 6]")}) == near(32.0));
  CHECK(through(block("MinMax", "Max", 9, {{"Function", "max"}, {"Inputs", "3"}}), three) == near(7.0));
  CHECK(through(block("Abs", "Abs", 9), {number(1, "-3")}) == near(3.0));
  CHECK(through(block("Signum", "Sign", 9), {number(1, "-3")}) == near(-1.0));
  CHECK(through(block("Polyval", "Polynomial", 9, {{"coefs", "[1 -2 3]"}}), {number(1, "3")}) == near(6.0));
}

TEST_CASE("a matrix gain multiplies a vector, an element-wise one its elements") {
  const std::string pick =
      block("Selector", "Selector", 8, {{"Indices", "2"}}) + line("9#out:1", {"8#in:1"}) +
      block("ToWorkspace", "W", 11, {{"VariableName", "z"}}) + line("8#out:1", {"11#in:1"});
  const auto second = [&](const P& parameters) {
    return Imported(ModelText{number(1, "[1 2]") + block("Gain", "Gain", 9, parameters) +
                              line("1#out:1", {"9#in:1"}) + pick})
        .last("z");
  };
  CHECK(second({{"Gain", "[1 2;3 4]"}, {"Multiplication", "Matrix(K*u)"}}) == near(11.0));
  CHECK(second({{"Gain", "[5 7]"}}) == near(14.0));
  const std::string matrices = number(1, "[1 2;3 4]") + number(2, "[0 1; 1 0]") +
                               block("Product", "P", 9, {{"Multiplication", "Matrix(*)"}}) +
                               block("ToWorkspace", "W", 10, {{"VariableName", "y"}}) +
                               line("1#out:1", {"9#in:1"}) + line("2#out:1", {"9#in:2"}) +
                               line("9#out:1", {"10#in:1"});
  CHECK(Imported(ModelText{matrices}).last("y.2.1") == near(4.0));
}

TEST_CASE("functions of Simulink have their formulas") {
  const auto math = [](const char* name, const std::vector<std::string>& of) {
    return through(block("Math", "Math", 9, {{"Operator", name}}), of);
  };
  CHECK(math("exp", {number(1, "1.5")}) == near(std::exp(1.5)));
  CHECK(math("10^u", {number(1, "2")}) == near(100.0));
  CHECK(math("square", {number(1, "-3")}) == near(9.0));
  CHECK(math("reciprocal", {number(1, "4")}) == near(0.25));
  CHECK(math("pow", {number(1, "2"), number(2, "10")}) == near(1024.0));
  CHECK(math("mod", {number(1, "-7"), number(2, "3")}) == near(2.0));
  CHECK(math("rem", {number(1, "-7"), number(2, "3")}) == near(-1.0));
  CHECK(math("mod", {number(1, "-7"), number(2, "0")}) == near(-7.0));
  CHECK(math("hypot", {number(1, "3"), number(2, "4")}) == near(5.0));
  CHECK(through(block("Sqrt", "Sqrt", 9, {{"Operator", "signedSqrt"}}), {number(1, "-9")}) == near(-3.0));
  CHECK(through(block("Sqrt", "Sqrt", 9, {{"Operator", "rSqrt"}}), {number(1, "4")}) == near(0.5));
  const auto trig = [](const char* name, const char* of) {
    return through(block("Trigonometry", "T", 9, {{"Operator", name}}), {number(1, of)});
  };
  CHECK(trig("cos", "0.3") == near(std::cos(0.3)));
  CHECK(trig("atanh", "0.3") == near(std::atanh(0.3)));
  CHECK(trig("asinh", "0.3") == near(std::asinh(0.3)));
  CHECK(through(block("Trigonometry", "T", 9, {{"Operator", "atan2"}}), {number(1, "1"), number(2, "-1")}) ==
        near(0.75 * pi));
  CHECK(through(block("Trigonometry", "T", 9, {{"Operator", "sincos"}}), {number(1, "0.4")}, "1", 2) ==
        near(std::cos(0.4)));
  const auto rounded = [](const char* name, const char* of) {
    return through(block("Rounding", "R", 9, {{"Operator", name}}), {number(1, of)});
  };
  CHECK(rounded("fix", "-2.7") == near(-2.0));
  CHECK(rounded("round", "-2.5") == near(-3.0));
  CHECK(rounded("ceil", "2.1") == near(3.0));
  CHECK(through(block("Fcn", "Fcn", 9, {{"Expr", "2*sin(u(1)) + u[2]^2 - (u(1) > 0 & ~0)"}}),
                {number(1, "[0.5 3]")}) == near(2.0 * std::sin(0.5) + 8.0));
  CHECK(through(block("Fcn", "Fcn", 9, {{"Expr", "exp(-u)*1e-1"}}), {number(1, "2")}) ==
        near(0.1 * std::exp(-2.0)));
}

TEST_CASE("formulas have the precedence of their language") {
  const auto matlab = [](const std::string& text) {
    return through(block("MATLABFcn", "F", 9, {{"MATLABFcn", text}}), {number(1, "2")});
  };
  const auto fcn = [](const std::string& text) {
    return through(block("Fcn", "F", 9, {{"Expr", text}}), {number(1, "2")});
  };
  for (const auto& value : {matlab("u^2^3"), fcn("u^2^3"), matlab("u.^2.^3"), fcn("u(1) ^ 2 ^ 3")})
    CHECK(value == near(64.0));
  CHECK(matlab("-u^2") == near(-4.0));
  CHECK(fcn("-u^2") == near(-4.0));
  CHECK(matlab("u^-1") == near(0.5));
  CHECK(matlab("u^-1^2") == near(0.25));
  CHECK(matlab("--u") == near(2.0));
  CHECK(matlab("3 - -u") == near(5.0));
  CHECK(matlab("2.^u'") == near(4.0));
  CHECK(matlab("8/u/u - 1 - 2") == near(-1.0));
  CHECK(matlab("2*-u^2") == near(-8.0));
  CHECK(matlab("8/(u*2)") == near(2.0));
  CHECK(matlab("~u == 0") == near(1.0));  // (~u) == 0
  CHECK(matlab("-~u") == near(0.0));
  CHECK(matlab("3 > u > 1") == near(0.0));   // (3 > 2) > 1
  CHECK(matlab("1 == u < 3") == near(1.0));  // (1 == 2) < 3; in C 1 == (2 < 3) is 1 as well
  CHECK(matlab("5 == u < 0") == near(0.0));
  CHECK(matlab("0 == u > 1") == near(0.0));
  CHECK(matlab("2 == u < 1") == near(0.0));      // (2 == 2) < 1
  CHECK(fcn("0 == u < 1") == near(1.0));         // 0 == (2 < 1)
  CHECK(matlab("u > 1 | 1 && 0") == near(0.0));  // (1 | 1) && 0
  CHECK(matlab("1 || u > 1 && 0") == near(1.0));
  CHECK(matlab("1 | 1 & 0") == near(1.0));
  CHECK(fcn("1 || 1 && 0") == near(1.0));
  CHECK_THAT(Imported(ModelText{number(1, "[1 2]") + block("MATLABFcn", "F", 9, {{"MATLABFcn", "2*u"}}) +
                                line("1#out:1", {"9#in:1"})})
                 .notes(NoteKind::placeholder),
             Catch::Contains("its formula has the whole vector u"));
}

TEST_CASE("lookup tables go on beyond their points or hold, as the model says") {
  const P points{
      {"NumberOfTableDimensions", "1"}, {"BreakpointsForDimension1", "[0 1 2]"}, {"Table", "[0 10 40]"}};
  P held = points, spaced = points;
  held["ExtrapMethod"] = "Clip";
  spaced["BreakpointsSpecification"] = "Even spacing";
  spaced["BreakpointsForDimension1FirstPoint"] = "1";
  spaced["BreakpointsForDimension1Spacing"] = "2";
  CHECK(through(block("Lookup_n-D", "Table", 9, points), {number(1, "1.5")}) == near(25.0));
  CHECK(through(block("Lookup_n-D", "Table", 9, points), {number(1, "3")}) == near(70.0));
  CHECK(through(block("Lookup_n-D", "Table", 9, held), {number(1, "3")}) == near(40.0));
  CHECK(through(block("Lookup_n-D", "Table", 9, spaced), {number(1, "4")}) == near(25.0));
  const P surface{{"NumberOfTableDimensions", "2"},
                  {"BreakpointsForDimension1", "[0 1]"},
                  {"BreakpointsForDimension2", "[0 2]"},
                  {"Table", "[0 1;2 3]"}};
  CHECK(through(block("Lookup_n-D", "Surface", 9, surface), {number(1, "0.5"), number(2, "1")}) == near(1.5));
  CHECK(through(block("Lookup", "Old", 9,
                      {{"InputValues", "[0 1]"},
                       {"Table", "[0 2]"},
                       {"LookUpMeth", "Interpolation-Use End Values"}}),
                {number(1, "5")}) == near(2.0));
}

TEST_CASE("discontinuities have their widths and limits") {
  CHECK(through(block("Saturate", "Saturation", 9), {number(1, "3")}) == near(0.5));
  CHECK(through(block("Saturate", "Saturation", 9, {{"UpperLimit", "inf"}, {"LowerLimit", "-2"}}),
                {number(1, "-3")}) == near(-2.0));
  CHECK(through(block("DeadZone", "Dead Zone", 9, {{"LowerValue", "-1"}, {"UpperValue", "2"}}),
                {number(1, "5")}) == near(3.0));
  CHECK(through(block("Quantizer", "Quantizer", 9, {{"QuantizationInterval", "0.5"}}),
                {number(1, "-1.25")}) == near(-1.5));
  CHECK(through(block("Backlash", "Backlash", 9, {{"BacklashWidth", "1"}}), {time_source(1)}, "2") ==
        near(1.5));
  CHECK(through(block("Relay", "Relay", 9,
                      {{"OnSwitchValue", "0.5"},
                       {"OffSwitchValue", "0.2"},
                       {"OnOutputValue", "7"},
                       {"OffOutputValue", "-7"}}),
                {time_source(1)}, "0.6") == near(7.0));
  CHECK(through(block("RateLimiter", "Rate Limiter", 9, {{"RisingSlewLimit", "0.5"}}), {time_source(1)},
                "2") == near(1.0));
  CHECK(through(block("RateLimiter", "Rate Limiter", 9), {number(1, "5")}, "2") == near(5.0));
  CHECK(through(reference("simulink/Discontinuities/Coulomb &\nViscous Friction", "Friction", 9,
                          {{"offset", "2"}, {"gain", "3"}}),
                {number(1, "-2")}) == near(-8.0));
  CHECK(through(reference("simulink/Discontinuities/Saturation\nDynamic", "S", 9),
                {number(1, "4"), number(2, "9"), number(3, "-1")}) == near(4.0));
}

TEST_CASE("comparisons and switches decide as in Simulink") {
  const auto chosen = [](const P& parameters, const char* control) {
    return through(block("Switch", "Switch", 9, parameters),
                   {number(1, "10"), number(2, control), number(3, "20")});
  };
  CHECK(chosen({{"Criteria", "u2 >= Threshold"}, {"Threshold", "2"}}, "2") == near(10.0));
  CHECK(chosen({{"Criteria", "u2 > Threshold"}, {"Threshold", "2"}}, "2") == near(20.0));
  CHECK(chosen({{"Criteria", "u2 ~= 0"}, {"Threshold", "2"}}, "-1") == near(10.0));
  CHECK(chosen({}, "-1") == near(20.0));
  CHECK(through(block("RelationalOperator", "R", 9, {{"Operator", "~="}}),
                {number(1, "1"), number(2, "2")}) == near(1.0));
  CHECK(through(reference("simulink/Logic and Bit\nOperations/Compare\nTo Constant", "C", 9,
                          {{"relop", ">"}, {"const", "3"}}),
                {number(1, "3")}) == near(0.0));
  CHECK(through(reference("simulink/Logic and Bit\nOperations/Compare\nTo Zero", "C", 9, {{"relop", "=="}}),
                {number(1, "0")}) == near(1.0));
  const auto joined = [](const char* name) {
    return through(block("Logic", "L", 9, {{"Operator", name}, {"Inputs", "2"}}),
                   {number(1, "-3"), number(2, "0")});
  };
  CHECK(joined("AND") == near(0.0));
  CHECK(joined("OR") == near(1.0));
  CHECK(joined("NAND") == near(1.0));
  CHECK(joined("NOR") == near(0.0));
  CHECK(joined("XOR") == near(1.0));
  CHECK(joined("NXOR") == near(0.0));
  CHECK(through(block("Logic", "L", 9, {{"Operator", "NOT"}}), {number(1, "-3")}) == near(0.0));
  CHECK(through(reference("simulink/Logic and Bit\nOperations/Interval\nTest", "I", 9,
                          {{"uplimit", "2"}, {"lowlimit", "1"}, {"IntervalClosedRight", "off"}}),
                {number(1, "2")}) == near(0.0));
  const auto picked = [](const char* index) {
    return through(block("MultiPortSwitch", "M", 9, {{"Inputs", "3"}}),
                   {number(1, index), number(2, "5"), number(3, "6"), number(4, "7")});
  };
  CHECK(picked("1") == near(5.0));
  CHECK(picked("2") == near(6.0));
  CHECK(picked("3") == near(7.0));
}

}  // namespace stepwire::simulink
