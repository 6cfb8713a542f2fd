// Blocks with states, in models whose runs have a closed form.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/app/simulink/slx.hpp"

using Catch::Contains;

namespace stepwire::simulink {

namespace {

Approx near(double value) {
  return Approx(value).epsilon(1e-7).margin(1e-9);
}

}  // namespace

TEST_CASE("continuous blocks of Simulink follow their equations") {
  CHECK(through(block("Integrator", "I", 9, {{"InitialCondition", "2"}}), {number(1, "3")}) == near(5.0));
  CHECK(through(block("Integrator", "I", 9, {{"LimitOutput", "on"}, {"UpperSaturationLimit", "1.5"}}),
                {number(1, "3")}) == near(1.5));
  CHECK(through(block("Integrator", "I", 9, {{"UpperSaturationLimit", "1.5"}}), {number(1, "3")}) ==
        near(3.0));
  CHECK(through(block("Integrator", "I", 9, {{"InitialConditionSource", "external"}}),
                {number(1, "3"), number(2, "4")}) == near(7.0));
  CHECK(through(block("SecondOrderIntegrator", "I", 9, {{"ICX", "1"}, {"ICDXDT", "2"}}), {number(1, "6")}) ==
        near(6.0));
  CHECK(through(block("SecondOrderIntegrator", "I", 9, {{"ICX", "1"}, {"ICDXDT", "2"}}), {number(1, "6")},
                "1", 2) == near(8.0));
  CHECK(through(block("TransferFcn", "G", 9, {{"Numerator", "[3]"}, {"Denominator", "[0.5 1]"}}),
                {number(1, "1")}) == near(3.0 * (1.0 - std::exp(-2.0))));
  CHECK(through(block("ZeroPole", "G", 9, {{"Zeros", "[]"}, {"Poles", "[-1 -2]"}, {"Gain", "4"}}),
                {number(1, "1")}) == near(2.0 - 4.0 * std::exp(-1.0) + 2.0 * std::exp(-2.0)));
  CHECK(through(block("StateSpace", "S", 9,
                      {{"A", "[0 1;0 0]"},
                       {"B", "[0;1]"},
                       {"C", "[1 0]"},
                       {"D", "0"},
                       {"InitialCondition", "[1 2]"}}),
                {number(1, "2")}) == near(4.0));
  CHECK(through(block("TransportDelay", "D", 9, {{"DelayTime", "0.25"}, {"InitialOutput", "-1"}}),
                {time_source(1)}, "1") == near(0.75));
  CHECK(through(block("TransportDelay", "D", 9, {{"DelayTime", "0.25"}, {"InitialOutput", "-1"}}),
                {time_source(1)}, "0.2") == near(-1.0));
}

TEST_CASE("an integrator is reset as its model says") {
  const std::string system = number(1, "1") + block("Step", "Step", 2, {{"Time", "0.6"}}) +
                             block("Integrator", "I", 9, {{"ExternalReset", "rising"}}) +
                             block("ToWorkspace", "W", 10, {{"VariableName", "y"}}) +
                             line("1#out:1", {"9#in:1"}) + line("2#out:1", {"9#in:2"}) +
                             line("9#out:1", {"10#in:1"});
  CHECK(Imported(ModelText{system}).last("y") == near(0.4));
}

TEST_CASE("a block IC gives an integrator its initial value, and its input what a reset goes to") {
  CHECK(through(block("Integrator", "I", 9, {{"InitialConditionSource", "external"}}),
                {number(1, "3"), block("InitialCondition", "IC", 2, {{"Value", "4"}})}) == near(7.0));
  // A ball that is thrown up at 15 m/s from 10 m, and leaves the floor with 0.8 of its speed
  const std::string ball =
      number(1, "-9.81") +
      block("Integrator", "v", 2,
            {{"ExternalReset", "falling"}, {"InitialConditionSource", "external"}, {"ShowStatePort", "on"}}) +
      block("Integrator", "x", 3,
            {{"InitialCondition", "10"}, {"LimitOutput", "on"}, {"LowerSaturationLimit", "0"}}) +
      block("Gain", "bounce", 4, {{"Gain", "-0.8"}}) + block("InitialCondition", "IC", 5, {{"Value", "15"}}) +
      block("ToWorkspace", "W", 10, {{"VariableName", "y"}}) + line("1#out:1", {"2#in:1"}) +
      line("2#out:1", {"3#in:1"}) + line("2#state", {"4#in:1"}) + line("4#out:1", {"5#in:1"}) +
      line("5#out:1", {"2#in:3"}) + line("3#out:1", {"2#in:2", "10#in:1"});
  ModelText model{ball};
  model.solver = {{"Solver", "ode45"}, {"StopTime", "5"}, {"RelTol", "1e-9"}};
  const Imported imported(model);
  CHECK_FALSE(imported.result.is_unfinished());
  const double g = 9.81, speed = std::sqrt(15.0 * 15.0 + 2.0 * g * 10.0), flight = 5.0 - (15.0 + speed) / g;
  CHECK(imported.last("y") == Approx(0.8 * speed * flight - 0.5 * g * flight * flight).epsilon(1e-7));
}

TEST_CASE("a level resets while it is not zero, also below zero") {
  const auto end = [](const std::string& integrator, const P& step) {
    const std::string system = number(1, "1") + block("Step", "Step", 2, step) + integrator +
                               block("ToWorkspace", "W", 10, {{"VariableName", "y"}}) +
                               line("1#out:1", {"9#in:1"}) + line("2#out:1", {"9#in:2"}) +
                               line("9#out:1", {"10#in:1"});
    return Imported(ModelText{system}).last("y");
  };
  const std::string continuous =
      block("Integrator", "I", 9, {{"ExternalReset", "level"}, {"InitialCondition", "3"}});
  CHECK(end(continuous, {{"Time", "0.5"}, {"Before", "-1"}, {"After", "0"}}) == near(3.5));
  CHECK(end(continuous, {{"Time", "0.5"}, {"Before", "2"}, {"After", "0"}}) == near(3.5));
  CHECK(end(continuous, {{"Time", "0.5"}, {"Before", "0"}, {"After", "-1"}}) == near(3.0));
  // The sample at 0.5 s resets as well, so that half a second remains.
  const std::string discrete =
      block("DiscreteIntegrator", "I", 9,
            {{"ExternalReset", "level"}, {"InitialCondition", "3"}, {"SampleTime", "0.1"}});
  CHECK(end(discrete, {{"Time", "0.5"}, {"Before", "-1"}, {"After", "0"}}) == near(3.5));
}

TEST_CASE("discrete blocks of Simulink act at their sample times") {
  const P tenth{{"SampleTime", "0.1"}};
  const auto with = [&](P parameters) {
    parameters.insert(tenth.begin(), tenth.end());
    return parameters;
  };
  CHECK(through(block("UnitDelay", "z", 9, with({{"InitialCondition", "5"}})), {time_source(1)}, "0.05") ==
        near(5.0));
  CHECK(through(block("UnitDelay", "z", 9, tenth), {time_source(1)}, "0.55") == near(0.4));
  CHECK(through(block("ZeroOrderHold", "h", 9, tenth), {time_source(1)}, "0.55") == near(0.5));
  CHECK(through(block("Delay", "d", 9, with({{"DelayLength", "3"}})), {time_source(1)}, "0.55") == near(0.2));
  CHECK(through(block("DiscreteIntegrator", "i", 9, with({{"gainval", "2"}, {"InitialCondition", "1"}})),
                {number(1, "3")}, "1") == near(7.0));
  CHECK(through(
            block("DiscreteIntegrator", "i", 9, with({{"IntegratorMethod", "Accumulation: Forward Euler"}})),
            {number(1, "3")}, "1") == near(30.0));
  // y[k] = 0.5 y[k-1] + u[k-1]: 2 (1 - 0.5^k)
  CHECK(
      through(block("DiscreteTransferFcn", "g", 9, with({{"Numerator", "[1]"}, {"Denominator", "[1 -0.5]"}})),
              {number(1, "1")}, "0.5") == near(2.0 * (1.0 - std::pow(0.5, 5))));
  // y[k] = 0.5 y[k-1] + u[k]: 2 - 0.5^k
  CHECK(through(block("DiscreteFilter", "g", 9, with({{"Numerator", "[1]"}, {"Denominator", "[1 -0.5]"}})),
                {number(1, "1")}, "0.5") == near(2.0 - std::pow(0.5, 5)));
  CHECK(through(block("DiscreteFir", "g", 9, with({{"Coefficients", "[0.25 0.75]"}})), {time_source(1)},
                "0.55") == near(0.25 * 0.5 + 0.75 * 0.4));
  CHECK(through(block("DiscreteZeroPole", "g", 9, with({{"Zeros", "[]"}, {"Poles", "[0.5]"}, {"Gain", "1"}})),
                {number(1, "1")}, "0.5") == near(2.0 * (1.0 - std::pow(0.5, 5))));
  CHECK(through(block("DiscreteStateSpace", "g", 9, with({{"A", "0.5"}, {"B", "1"}, {"C", "1"}, {"D", "0"}})),
                {number(1, "1")}, "0.5") == near(2.0 * (1.0 - std::pow(0.5, 5))));
  CHECK(through(block("Memory", "m", 9), {time_source(1)}, "0.5") == near(0.49));
}

TEST_CASE("a discrete model has the step of its sample times, and no solver") {
  ModelText model{time_source(1) + block("ZeroOrderHold", "h", 9, {{"SampleTime", "[0.3 0.1]"}}) +
                  block("Scope", "Scope", 10) + line("1#out:1", {"9#in:1"}) + line("9#out:1", {"10#in:1"})};
  model.solver = {{"Solver", "FixedStepDiscrete"}, {"FixedStep", "auto"}, {"StopTime", "1"}};
  const Imported imported(model);
  CHECK_THAT(imported.text(),
             Contains("step: 0.1 s") && !Contains("solver") && Contains("every: {period: 0.3, offset: 0.1}"));
  CHECK(imported.last("h") == near(1.0));
}

TEST_CASE("parameters that are not in the file have the defaults of Simulink, and the report says so") {
  // 1/(s + 1)^2 answers a step with 1 - (1 + t) exp(-t)
  CHECK(through(block("TransferFcn", "G", 9), {number(1, "1")}) == near(1.0 - 2.0 * std::exp(-1.0)));
  CHECK(through(block("UnitDelay", "z", 9), {time_source(1)}, "2.5") == near(1.0));
  CHECK(through(block("RelationalOperator", "R", 9), {number(1, "2"), number(2, "2")}) == near(1.0));
  const Imported imported(
      ModelText{number(1, "1") + block("TransferFcn", "G", 9) + line("1#out:1", {"9#in:1"})});
  CHECK_THAT(imported.notes(NoteKind::differs), Contains("G: its Denominator is not in the file; [1 2 1]"));
  const Imported pulse(
      ModelText{block("DiscretePulseGenerator", "Gate", 1, {{"PulseType", "Time based"}, {"Period", "2"}})});
  CHECK_THAT(pulse.notes(NoteKind::missing), Contains("'Gate_PulseWidth' has no value in the file"));
}

TEST_CASE("controllers have their forms") {
  const auto continuous = [](P parameters) {
    return through(reference("slpidlib/PID Controller", "PID Controller", 9, parameters), {number(1, "2")},
                   "1");
  };
  // P e + I e t + D N e exp(-N t)
  CHECK(continuous({{"P", "3"}, {"I", "4"}, {"D", "0.5"}, {"N", "10"}}) ==
        near(6.0 + 8.0 + 0.5 * 10.0 * 2.0 * std::exp(-10.0)));
  CHECK(continuous({{"P", "3"}, {"I", "4"}, {"Form", "Ideal"}}) == near(6.0 + 24.0));
  CHECK(continuous({{"Controller", "P"}, {"P", "3"}, {"I", "4"}}) == near(6.0));
  CHECK(continuous({{"P", "3"}, {"I", "4"}, {"LimitOutput", "on"}, {"UpperSaturationLimit", "8"}}) ==
        near(8.0));
  const P sampled{{"TimeDomain", "Discrete-time"}, {"SampleTime", "0.1"}, {"P", "3"}, {"I", "4"}};
  CHECK(continuous(sampled) == near(6.0 + 4.0 * 0.1 * 2.0 * 10.0));
  CHECK(through(reference("slpidlib/PID Controller (2DOF)", "C", 9,
                          {{"P", "2"}, {"I", "0"}, {"D", "0"}, {"b", "0.5"}}),
                {number(1, "4"), number(2, "1")}) == near(2.0 * (0.5 * 4.0 - 1.0)));
}

TEST_CASE("a loop of numbers without units gets a gain where units would differ") {
  // x'' = -sin(x) - 1 while x > 0.5
  const std::string system = block("Integrator", "x", 1, {{"InitialCondition", "1"}}) +
                             block("Integrator", "v", 2) + block("Trigonometry", "sin", 3) +
                             block("RelationalOperator", "above", 4, {{"Operator", ">"}}) + number(5, "0.5") +
                             block("Sum", "acceleration", 6, {{"Inputs", "--"}}) +
                             block("ToWorkspace", "W", 10, {{"VariableName", "y"}}) +
                             line("1#out:1", {"3#in:1", "4#in:1", "10#in:1"}) + line("5#out:1", {"4#in:2"}) +
                             line("2#out:1", {"1#in:1"}) + line("3#out:1", {"6#in:1"}) +
                             line("4#out:1", {"6#in:2"}) + line("6#out:1", {"2#in:1"});
  ModelText model{system};
  model.solver["StopTime"] = "0.5";
  model.solver["FixedStep"] = "0.001";
  const Imported imported(model);
  CHECK(imported.notes(NoteKind::fault).empty());
  // a Runge-Kutta of order 4 with 5000 steps in Python gives 0.7725734633487593
  CHECK(imported.last("y") == Approx(0.7725734633).epsilon(1e-8));
}

TEST_CASE("solvers have their names here, and tolerances are kept") {
  const auto head = [](const P& solver) {
    ModelText model{number(1, "1") + block("Integrator", "I", 9) + line("1#out:1", {"9#in:1"})};
    model.solver = solver;
    return Imported(model).text();
  };
  CHECK_THAT(head({{"Solver", "ode1"}, {"FixedStep", "0.01"}, {"StopTime", "2"}}),
             Contains("solver: euler") && Contains("step: 0.01 s") && Contains("stop: 2 s"));
  CHECK_THAT(head({{"Solver", "ode45"}, {"RelTol", "1e-5"}, {"AbsTol", "auto"}, {"StopTime", "2"}}),
             Contains("solver: {name: dormand_prince, relative: 1e-05, absolute: 1e-6}") &&
                 Contains("events: locate"));
  CHECK_THAT(head({{"Solver", "ode15s"}, {"StopTime", "2"}}), Contains("name: radau"));
  CHECK_THAT(head({{"Solver", "VariableStepAuto"}, {"StopTime", "2"}, {"ZeroCrossControl", "DisableAll"}}),
             Contains("name: auto") && !Contains("events"));
  CHECK_THAT(head({{"Solver", "ode3"}, {"FixedStep", "auto"}, {"StopTime", "5"}}),
             Contains("step: 0.1 s") && Contains("bogacki_shampine"));
}

}  // namespace stepwire::simulink
