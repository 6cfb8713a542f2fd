// Systems in systems, tags, masks, variables, buses and conditions.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/app/simulink/slx.hpp"

using Catch::Contains;

namespace stepwire::simulink {

namespace {

Approx near(double value) {
  return Approx(value).epsilon(1e-7).margin(1e-9);
}

std::string port(const std::string& type, const std::string& name, int sid, int number = 1) {
  return block(type, name, sid, number == 1 ? P{} : P{{"Port", std::to_string(number)}});
}

std::string sink(int sid, const std::string& name = "y") {
  return block("ToWorkspace", "To Workspace" + std::to_string(sid), sid, {{"VariableName", name}});
}

/// A subsystem with this content.
std::string subsystem(const std::string& name, int sid, const std::string& content,
                      const std::string& mask = "") {
  return block("SubSystem", name, sid, {}, mask + "<System>" + content + "</System>");
}

}  // namespace

TEST_CASE("the layouts of old and new releases give the same diagram") {
  ModelText model{number(1, "2") +
                  subsystem("Plant", 2,
                            port("Inport", "In1", 3) + block("Gain", "Gain", 4, {{"Gain", "3"}}) +
                                port("Outport", "Out1", 5) + line("3#out:1", {"4#in:1"}) +
                                line("4#out:1", {"5#in:1"})) +
                  sink(6) + line("1#out:1", {"2#in:1"}) + line("2#out:1", {"6#in:1"})};
  const Imported modern(model);
  model.is_new = false;
  const Imported old(model);
  CHECK(modern.text() == old.text());
  CHECK_THAT(modern.text(), Contains("Plant.Gain: {block: Gain, u: Constant1, gain: 3}"));
  CHECK(modern.last("y") == near(6.0));
}

TEST_CASE("a subsystem may be in a file of its own, and lines of R2012 name blocks") {
  testing::Entries entries = entries_of(
      {number(1, "2") + block("SubSystem", "Plant", 2, {}, "<System Ref=\"system_2\"/>") + sink(6) +
       "<Line><P Name=\"SrcBlock\">Constant1</P><P Name=\"SrcPort\">1</P><P Name=\"DstBlock\">Plant</P><P "
       "Name=\"DstPort\">1</P></Line>" +
       line("2#out:1", {"6#in:1"})});
  entries["simulink/systems/system_2.xml"] =
      "<System>" + port("Inport", "In1", 3) + block("Gain", "Gain", 4, {{"Gain", "3"}}) +
      port("Outport", "Out1", 5) + line("3#out:1", {"4#in:1"}) + line("4#out:1", {"5#in:1"}) + "</System>";
  CHECK(Imported(entries).last("y") == near(6.0));
}

TEST_CASE("defaults of the file hold for parameters that blocks leave out") {
  ModelText model{number(1, "2") + block("Gain", "Gain", 9) + sink(10) + line("1#out:1", {"9#in:1"}) +
                  line("9#out:1", {"10#in:1"})};
  model.defaults = "<Block BlockType=\"Gain\"><P Name=\"Gain\">11</P></Block>";
  CHECK(Imported(model).last("y") == near(22.0));
}

TEST_CASE("Goto and From are a name, also through subsystems") {
  const std::string inside = block("From", "From", 3, {{"GotoTag", "speed"}}) + port("Outport", "Out1", 5) +
                             line("3#out:1", {"5#in:1"});
  const Imported imported(ModelText{
      number(1, "4") + block("Goto", "Goto", 2, {{"GotoTag", "speed"}, {"TagVisibility", "global"}}) +
      line("1#out:1", {"2#in:1"}) + subsystem("Inner", 6, inside) + sink(7) + line("6#out:1", {"7#in:1"})});
  CHECK(imported.last("y") == near(4.0));
}

TEST_CASE("variables of callbacks are parameters, and those of masks their formulas") {
  const std::string mask =
      "<Mask><MaskParameter Name=\"k\" "
      "Type=\"edit\"><Value>2*stiffness</Value></MaskParameter><Initialization>twice = "
      "2*k;</Initialization></Mask>";
  const std::string inside = port("Inport", "In1", 3) + block("Gain", "Gain", 4, {{"Gain", "twice + 1"}}) +
                             port("Outport", "Out1", 5) + line("3#out:1", {"4#in:1"}) +
                             line("4#out:1", {"5#in:1"});
  ModelText model{number(1, "load(2)") + subsystem("Spring", 2, inside, mask) + sink(6) +
                  line("1#out:1", {"2#in:1"}) + line("2#out:1", {"6#in:1"})};
  model.callbacks = {{"PreLoadFcn", "stiffness = 3; % N/m\nload = [1 5];\nunused = 7;"}};
  const Imported imported(model);
  CHECK_THAT(imported.text(),
             Contains("parameters: {load: [1, 5], stiffness: 3}") && Contains("gain: = 2*(2*stiffness) + 1"));
  CHECK(imported.last("y") == near(5.0 * 13.0));
  CHECK_FALSE(imported.result.is_unfinished());
}

TEST_CASE("a variable without a value is named, and the diagram asks for it") {
  const Imported imported(ModelText{number(1, "mass*9.81") + sink(2) + line("1#out:1", {"2#in:1"})});
  CHECK(imported.notes(NoteKind::missing) ==
        ": 'mass' has no value in the file; give it one under 'parameters'\n");
  CHECK(imported.notes(NoteKind::fault).empty());
  CHECK(imported.result.is_unfinished());
  CHECK_THAT(imported.text(), Contains("mass: {doc:"));
  CHECK_THROWS_WITH(imported.run(), Contains("mass: 'value' is missing"));
}

TEST_CASE("variables whose names have another meaning here keep their values") {
  ModelText model{number(1, "stop + step + time") + block("Fcn", "Fcn", 2, {{"Expr", "u*u1 + x"}}) + sink(3) +
                  line("1#out:1", {"2#in:1"}) + line("2#out:1", {"3#in:1"})};
  model.callbacks = {{"PreLoadFcn", "stop = 1; step = 2; time = 4; u1 = 5; x = 9;"}};
  CHECK(Imported(model).last("y") == near(44.0));
}

TEST_CASE("a choice in a mask is its number in the list, and a box is 1 or 0, where they are evaluated") {
  const auto with = [](const std::string& parameter) {
    const std::string inside = port("Inport", "In1", 3) + block("Gain", "Gain", 4, {{"Gain", "k"}}) +
                               port("Outport", "Out1", 5) + line("3#out:1", {"4#in:1"}) +
                               line("4#out:1", {"5#in:1"});
    return Imported(ModelText{number(1, "2") +
                              subsystem("Choice", 2, inside, "<Mask>" + parameter + "</Mask>") + sink(6) +
                              line("1#out:1", {"2#in:1"}) + line("2#out:1", {"6#in:1"})})
        .last("y");
  };
  const std::string options =
      "<TypeOptions><Option>10</Option><Option>3</Option><Option>5</Option></TypeOptions>";
  CHECK(with("<MaskParameter Name=\"k\" Type=\"popup\"><Value>5</Value>" + options + "</MaskParameter>") ==
        near(6.0));
  CHECK(with("<MaskParameter Name=\"k\" Type=\"popup\" Evaluate=\"off\"><Value>5</Value>" + options +
             "</MaskParameter>") == near(10.0));
  CHECK(with("<MaskParameter Name=\"k\" Type=\"checkbox\"><Value>on</Value></MaskParameter>") == near(2.0));
}

TEST_CASE("a variable hides the function of its name") {
  ModelText model{number(1, "eps + poly(1) + max(2)") + sink(2) + line("1#out:1", {"2#in:1"})};
  model.callbacks = {{"PreLoadFcn", "eps = 0.1; poly = [7 8 9]; max = [8 9];"}};
  CHECK(Imported(model).last("y") == near(0.1 + 7.0 + 9.0));
}

TEST_CASE("a later callback changes no variable that follows from the former value") {
  ModelText model{number(1, "b + 10*a") + sink(2) + line("1#out:1", {"2#in:1"})};
  model.callbacks = {{"PreLoadFcn", "a = 1; b = 2*a;"}, {"InitFcn", "a = 3*a;"}};
  CHECK(Imported(model).last("y") == near(2.0 + 30.0));
}

TEST_CASE("a delay that is shorter than the usual step makes the step shorter") {
  ModelText model{time_source(1) + block("TransportDelay", "D", 2, {{"DelayTime", "0.003"}}) + sink(3) +
                  line("1#out:1", {"2#in:1"}) + line("2#out:1", {"3#in:1"})};
  model.solver = {{"Solver", "ode45"}, {"StopTime", "10"}};
  CHECK(Imported(model).last("y") == near(9.997));
}

TEST_CASE("statements and branches of callbacks are not executed, and said") {
  ModelText model{number(1, "2") + sink(2) + line("1#out:1", {"2#in:1"})};
  model.callbacks = {{"InitFcn", "load('data.mat')"}, {"PreLoadFcn", "if true\n k = 3;\nend"}};
  CHECK_THAT(Imported(model).notes(NoteKind::differs),
             Contains("InitFcn has 'load('data.mat')', which is not executed") &&
                 Contains("PreLoadFcn has branches or loops"));
}

TEST_CASE("Mux, Demux and buses lead each signal to its place") {
  const std::string both = number(1, "[4 5]") + number(2, "6") + block("Mux", "Mux", 3, {{"Inputs", "2"}}) +
                           line("1#out:1", {"3#in:1"}) + line("2#out:1", {"3#in:2"});
  CHECK(Imported(ModelText{both + block("Demux", "Demux", 4, {{"Outputs", "3"}}) +
                           line("3#out:1", {"4#in:1"}) + sink(5) + line("4#out:2", {"5#in:1"})})
            .last("y") == near(5.0));
  CHECK(Imported(ModelText{both + block("Demux", "Demux", 4, {{"Outputs", "[2 1]"}}) +
                           line("3#out:1", {"4#in:1"}) + sink(5) + line("4#out:2", {"5#in:1"})})
            .last("y") == near(6.0));
  const std::string bus = number(1, "4") + number(2, "6") + block("BusCreator", "Bus", 3, {{"Inputs", "2"}}) +
                          line("1#out:1", {"3#in:1"}, "force") + line("2#out:1", {"3#in:2"}) +
                          block("BusSelector", "Pick", 4, {{"OutputSignals", "signal2,force"}}) +
                          line("3#out:1", {"4#in:1"});
  CHECK(Imported(ModelText{bus + sink(5) + line("4#out:2", {"5#in:1"})}).last("y") == near(4.0));
  CHECK(Imported(ModelText{bus + sink(5) + line("4#out:1", {"5#in:1"})}).last("y") == near(6.0));
}

TEST_CASE("an enabled subsystem is a part that holds or resets its states") {
  const auto counted = [](const char* states) {
    const std::string inside = block("EnablePort", "Enable", 20, {{"StatesWhenEnabling", states}}) +
                               port("Inport", "In1", 21) + block("Integrator", "I", 22) +
                               port("Outport", "Out1", 23) + line("21#out:1", {"22#in:1"}) +
                               line("22#out:1", {"23#in:1"});
    const std::string pulse = block("DiscretePulseGenerator", "Gate", 2,
                                    {{"PulseType", "Time based"}, {"Period", "0.4"}, {"PulseWidth", "50"}});
    return Imported(ModelText{number(1, "1") + pulse + subsystem("Timer", 3, inside) + sink(4) +
                              line("1#out:1", {"3#in:1"}) + line("2#out:1", {"3#enable"}) +
                              line("3#out:1", {"4#in:1"})})
        .last("y");
  };
  CHECK(counted("held") == near(0.6));  // on in 0 to 0.2, 0.4 to 0.6, 0.8 to 1
  CHECK(counted("reset") == near(0.2));
}

TEST_CASE("the outputs of a disabled subsystem have the value that the model gives them") {
  const std::string inside =
      block("EnablePort", "Enable", 20) + port("Inport", "In1", 21) + block("Gain", "Gain", 22) +
      block("Outport", "Out1", 23, {{"OutputWhenDisabled", "reset"}, {"InitialOutput", "-4"}}) +
      line("21#out:1", {"22#in:1"}) + line("22#out:1", {"23#in:1"});
  const Imported imported(ModelText{
      number(1, "7") + block("Step", "Step", 2, {{"Time", "0.5"}, {"Before", "1"}, {"After", "0"}}) +
      subsystem("S", 3, inside) + sink(4) + line("1#out:1", {"3#in:1"}) + line("2#out:1", {"3#enable"}) +
      line("3#out:1", {"4#in:1"})});
  CHECK(imported.last("y") == near(-4.0));
}

TEST_CASE("a signal of a port block is a fault, and no silent 0") {
  const std::string inside = block("EnablePort", "Enable", 20, {{"ShowOutputPort", "on"}}) +
                             port("Outport", "Out1", 23) + line("20#out:1", {"23#in:1"});
  const Imported imported(ModelText{number(1, "7") + subsystem("S", 3, inside) + sink(4) +
                                    line("1#out:1", {"3#enable"}) + line("3#out:1", {"4#in:1"})});
  CHECK_THAT(imported.notes(NoteKind::fault), Contains("S/Enable: is read and has no signal here"));
}

TEST_CASE("a triggered subsystem takes its inputs at edges") {
  const std::string inside = block("TriggerPort", "Trigger", 20, {{"TriggerType", "rising"}}) +
                             port("Inport", "In1", 21) + port("Outport", "Out1", 23) +
                             line("21#out:1", {"23#in:1"});
  const Imported imported(ModelText{time_source(1) + block("Step", "Step", 2, {{"Time", "0.4"}}) +
                                    subsystem("Hold", 3, inside) + sink(4) + line("1#out:1", {"3#in:1"}) +
                                    line("2#out:1", {"3#trigger"}) + line("3#out:1", {"4#in:1"})});
  CHECK(imported.last("y") == near(0.4));
}

TEST_CASE("If and its actions are parts with conditions") {
  const auto action = [](const char* name, int sid, const char* value) {
    return subsystem(name, sid,
                     block("ActionPort", "Action", sid + 1) + number(sid + 2, value) +
                         port("Outport", "Out1", sid + 3) +
                         line(std::to_string(sid + 2) + "#out:1", {std::to_string(sid + 3) + "#in:1"}));
  };
  ModelText model{
      time_source(1) +
      block("If", "If", 2, {{"IfExpression", "u1 < 0.5"}, {"ShowElse", "on"}, {"Ports", "[1, 2]"}}) +
      action("Low", 10, "3") + action("High", 20, "8") + sink(30, "low") + sink(31, "high") +
      line("1#out:1", {"2#in:1"}) + line("2#out:1", {"10#ifaction"}) + line("2#out:2", {"20#ifaction"}) +
      line("10#out:1", {"30#in:1"}) + line("20#out:1", {"31#in:1"})};
  model.solver["StopTime"] = "0.3";
  CHECK(Imported(model).last("low") == near(3.0));
  CHECK(Imported(model).last("high") == near(0.0));
  model.solver["StopTime"] = "0.7";
  CHECK(Imported(model).last("high") == near(8.0));
  model.system += block("Merge", "Merge", 40) + sink(41, "merged") + line("10#out:1", {"40#in:1"}) +
                  line("20#out:1", {"40#in:2"}) + line("40#out:1", {"41#in:1"});
  CHECK(Imported(model).last("merged") == near(8.0));
  model.solver["StopTime"] = "0.3";
  CHECK(Imported(model).last("merged") == near(3.0));
}

TEST_CASE("a part gets the variables and tags that it reads") {
  const std::string inside = block("EnablePort", "Enable", 20) +
                             block("From", "From", 21, {{"GotoTag", "a"}}) +
                             block("Gain", "Gain", 22, {{"Gain", "k"}}) + port("Outport", "Out1", 23) +
                             line("21#out:1", {"22#in:1"}) + line("22#out:1", {"23#in:1"});
  ModelText model{number(1, "5") + block("Goto", "Goto", 2, {{"GotoTag", "a"}, {"TagVisibility", "global"}}) +
                  subsystem("S", 3, inside) + sink(4) + line("1#out:1", {"2#in:1", "3#enable"}) +
                  line("3#out:1", {"4#in:1"})};
  model.callbacks = {{"PreLoadFcn", "k = 7;"}};
  CHECK(Imported(model).last("y") == near(35.0));
}

TEST_CASE("an algebraic loop is solved where Simulink solves it") {
  // y = 1 - 0.5 y
  ModelText model{number(1, "1") + block("Sum", "Sum", 2, {{"Inputs", "+-"}}) +
                  block("Gain", "Gain", 3, {{"Gain", "0.5"}}) + sink(4) + line("1#out:1", {"2#in:1"}) +
                  line("2#out:1", {"3#in:1", "4#in:1"}) + line("3#out:1", {"2#in:2"})};
  const Imported imported(model);
  CHECK_THAT(imported.text(), Contains("algebraic_loops: solve"));
  CHECK(imported.last("y") == near(2.0 / 3.0));
  model.messages["AlgebraicLoopMsg"] = "error";
  CHECK_THAT(Imported(model).notes(NoteKind::fault), Contains("lgebraic loop"));
}

TEST_CASE("names, annotations, scopes and the end of a run come along") {
  const std::string annotation =
      "<Annotation SID=\"40\"><P Name=\"Name\">&lt;p&gt;a &lt;b&gt;slow&lt;/b&gt; "
      "tank&lt;/p&gt;</P></Annotation>";
  ModelText model{time_source(1) + block("Gain", "k/m (1)", 9, {{"Gain", "2"}}) +
                  block("Scope", "Scope", 10) +
                  reference("simulink/Logic and Bit Operations/Compare To Constant", "Late", 11,
                            {{"relop", ">="}, {"const", "0.5"}}) +
                  block("Stop", "Stop", 12) + annotation + line("1#out:1", {"9#in:1", "11#in:1"}) +
                  line("9#out:1", {"10#in:1"}) + line("11#out:1", {"12#in:1"})};
  const Imported imported(model);
  CHECK_THAT(imported.text(), Contains("# a slow tank") && Contains("k_m_1: {block: Gain") &&
                                  Contains("stop_when: Late != 0") && Contains("record: [k_m_1]"));
  CHECK_THAT(imported.notes(NoteKind::renamed), Contains("k/m (1): is called k_m_1"));
  CHECK(imported.last("k_m_1") == near(1.0));
}

TEST_CASE("a block without counterpart becomes a part that ends a run and says so") {
  const Imported imported(
      ModelText{number(1, "1") +
                block("S-Function", "Motor model", 2, {{"FunctionName", "sf_motor"}, {"Ports", "[1, 2]"}}) +
                sink(3) + line("1#out:1", {"2#in:1"}) + line("2#out:2", {"3#in:1"})});
  CHECK(imported.result.translated == imported.result.blocks - 1);
  CHECK_THAT(
      imported.notes(NoteKind::placeholder),
      Contains("Motor model: S-Function is not translated: there is no counterpart; write its blocks in"));
  CHECK(imported.notes(NoteKind::fault).empty());
  CHECK_THAT(imported.text(),
             Contains("Motor_model: {diagram: model-parts/Motor_model.yaml, u1: Constant1}"));
  CHECK_THAT(imported.part("Motor_model.yaml"), Contains("FunctionName = sf_motor"));
  CHECK_THAT(imported.fault(), Contains("Motor_model.write_the_blocks_of_Motor_model_here"));
}

TEST_CASE("a parameter that changes behaviour and has no counterpart is said, never dropped") {
  const auto notes = [](const std::string& one) {
    return Imported(ModelText{number(1, "1") + one + sink(10) + line("1#out:1", {"9#in:1"}) +
                              line("9#out:1", {"10#in:1"})});
  };
  CHECK_THAT(notes(block("Gain", "G", 9, {{"OutDataTypeStr", "int16"}})).notes(NoteKind::deviates),
             Contains("its data type is int16"));
  CHECK_THAT(
      notes(block("DataTypeConversion", "C", 9, {{"OutDataTypeStr", "uint8"}})).notes(NoteKind::deviates),
      Contains("converts to uint8"));
  CHECK_THAT(notes(block("Integrator", "I", 9, {{"WrapState", "on"}})).notes(NoteKind::placeholder),
             Contains("it wraps its state"));
  CHECK_THAT(
      notes(block("Lookup_n-D", "L", 9, {{"InterpMethod", "Cubic spline"}})).notes(NoteKind::placeholder),
      Contains("it interpolates by Cubic spline"));
  CHECK_THAT(notes(block("Gain", "G", 9, {{"Gain", "myfun(2)"}})).notes(NoteKind::placeholder),
             Contains("its parameter Gain, 'myfun(2)'"));
  CHECK_THAT(notes(block("RandomNumber", "R", 9)).notes(NoteKind::deviates),
             Contains("another sequence of numbers"));
  CHECK_THAT(notes(block("Gain", "G", 9, {{"ParamDataTypeStr", "fixdt(1,8,4)"}})).notes(NoteKind::deviates),
             Contains("its ParamDataTypeStr is fixdt(1,8,4), and that is of double precision here"));
  CHECK_THAT(notes(block("Gain", "G", 9, {{"OutDataTypeStr", "fixdt(1,16,2)"}})).notes(NoteKind::deviates),
             Contains("its data type is fixdt(1,16,2)"));
  CHECK_THAT(
      notes(block("Trigonometry", "T", 9, {{"ApproximationMethod", "CORDIC"}})).notes(NoteKind::deviates),
      Contains("its approximation is CORDIC in Simulink, and its function is exact here"));
  CHECK(notes(block("Trigonometry", "T", 9, {{"ApproximationMethod", "None"}}))
            .notes(NoteKind::deviates)
            .empty());
}

TEST_CASE("a run that begins or ends elsewhere is said, and the import is not finished") {
  const auto imported = [](const P& solver, const P& states = {}) {
    ModelText model{number(1, "1") + block("Integrator", "I", 9) + line("1#out:1", {"9#in:1"})};
    for (const auto& [name, text] : solver) model.solver[name] = text;
    model.states = states;
    return Imported(model);
  };
  CHECK_FALSE(imported({}).result.is_unfinished());
  CHECK_FALSE(imported({}, {{"LoadInitialState", "off"}, {"InitialState", "x0"}}).result.is_unfinished());
  const auto says = [&](const P& solver, const P& states, const std::string& sentence) {
    const Imported one = imported(solver, states);
    CHECK(one.result.is_unfinished());
    CHECK_THAT(one.notes(NoteKind::deviates), Contains(sentence));
  };
  says({}, {{"LoadInitialState", "on"}, {"InitialState", "[4]"}},
       "begins with the states of '[4]' in Simulink");
  says({{"StopTime", "inf"}}, {}, "has the stop time inf; 10 s is written");
  says({{"StartTime", "0.5"}}, {}, "begins at 0.5 s in Simulink, and at 0 here");
}

TEST_CASE("a block that is commented through is a wire, one that is commented out is left out") {
  const auto imported = [](const char* commented, const std::string& type, const std::string& ports) {
    return Imported(ModelText{
        number(1, "1") + number(2, "7") + block(type, "G", 9, {{"Commented", commented}, {"Ports", ports}}) +
        sink(4) + line("1#out:1", {"9#in:1"}) + line("2#out:1", {"9#in:2"}) + line("9#out:1", {"4#in:1"})});
  };
  const Imported gain = imported("through", "Gain", "[2, 2]");
  CHECK_FALSE(gain.result.is_unfinished());
  CHECK_THAT(gain.notes(NoteKind::differs), Contains("is commented through, and a wire here"));
  CHECK_THAT(gain.text(), Contains("{y: Constant1}") && !Contains("Gain"));
  const Imported sum = imported("through", "Sum", "[2, 1]");
  CHECK(sum.result.is_unfinished());
  CHECK_THAT(sum.notes(NoteKind::deviates),
             Contains("is commented through and has 2 inputs and 1 output; an output is the input of its"));
  const Imported out(
      ModelText{number(1, "1") + block("Gain", "G", 9, {{"Commented", "on"}}) + line("1#out:1", {"9#in:1"})});
  CHECK_FALSE(out.result.is_unfinished());
  CHECK_THAT(out.text(), !Contains("Gain"));
}

TEST_CASE("the placeholder of a resettable subsystem has its port Reset") {
  const std::string inside = block("ResetPort", "Reset", 20) + port("Inport", "In1", 21) +
                             block("Integrator", "I", 22) + port("Outport", "Out1", 23) +
                             line("21#out:1", {"22#in:1"}) + line("22#out:1", {"23#in:1"});
  const Imported imported(ModelText{
      number(1, "1") + block("Step", "Step", 2) +
      block("SubSystem", "S", 3, {{"Ports", "[1, 1]"}}, "<System>" + inside + "</System>") + sink(4) +
      line("1#out:1", {"3#in:1"}) + line("2#out:1", {"3#Reset"}) + line("3#out:1", {"4#in:1"})});
  CHECK(imported.notes(NoteKind::fault).empty());
  CHECK_THAT(imported.text(), Contains("S: {diagram: model-parts/S.yaml, u1: Constant1, Reset: Step}"));
  CHECK_THAT(imported.part("S.yaml"), Contains("Reset:"));
}

}  // namespace stepwire::simulink
