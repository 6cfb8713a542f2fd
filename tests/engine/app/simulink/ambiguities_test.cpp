// Places of a model that have two meanings.
#include <catch2/catch.hpp>

#include "tests/engine/app/simulink/slx.hpp"

using Catch::Contains;

namespace stepwire::simulink {

namespace {

std::string sink(int sid) {
  return block("ToWorkspace", "W", sid, {{"VariableName", "y"}});
}

std::string subsystem(const std::string& name, int sid, const std::string& content) {
  return block("SubSystem", name, sid, {}, "<System>" + content + "</System>");
}

std::string inport(const std::string& name, int sid, const P& parameters = {}) {
  return block("Inport", name, sid, parameters);
}

std::string sender(int sid, const std::string& visibility) {
  return block("Goto", "Send" + std::to_string(sid), sid, {{"GotoTag", "a"}, {"TagVisibility", visibility}});
}

/// Checks that an import is not finished, and has this fault.
void check_fault(const std::string& system, const std::string& sentence) {
  const Imported imported(ModelText{system});
  CHECK(imported.result.is_unfinished());
  CHECK_THAT(imported.notes(NoteKind::fault), Contains(sentence));
}

}  // namespace

TEST_CASE("two blocks with one SID are reported") {
  check_fault(block("Constant", "A", 1) + block("Constant", "B", 1) + sink(2) + line("1#out:1", {"2#in:1"}),
              "B: has the SID 1 of 'A' as well; lines lead to that one alone");
}

TEST_CASE("two blocks with one name are reported where they have no SID") {
  const std::string nameless = R"(<Block BlockType="Gain" Name="G"/>)";
  check_fault(nameless + nameless, "G: has the name of 'G' as well");
}

TEST_CASE("equal SIDs of two systems are no fault, as lines are within one") {
  const std::string inside = inport("In1", 1) + block("Outport", "Out1", 2) + line("1#out:1", {"2#in:1"});
  const Imported imported(ModelText{number(1, "3") + subsystem("S", 2, inside) + sink(3) +
                                    line("1#out:1", {"2#in:1"}) + line("2#out:1", {"3#in:1"})});
  CHECK_FALSE(imported.result.is_unfinished());
  CHECK(imported.last("y") == 3.0);
}

TEST_CASE("two ports with one number are reported, and bad numbers of ports") {
  const auto with = [](const std::string& inside) { return subsystem("S", 1, inside); };
  check_fault(with(inport("A", 2) + inport("B", 3)), "S/B: has the port number 1 of 'A' as well");
  check_fault(with(block("Outport", "A", 2) + block("Outport", "B", 3)),
              "S/B: has the port number 1 of 'A' as well; that one is written");
  check_fault(with(inport("A", 2, {{"Port", "x"}})), "S/A: has the port number 'x'; 1 is written");
  check_fault(inport("A", 2, {{"Port", "9"}}), "A: has the port number 9, and its system has 1 blocks");
  CHECK_THAT(Imported(ModelText{with(inport("A", 2) + block("InportShadow", "B", 3))}).notes(NoteKind::fault),
             !Contains("port number"));
}

TEST_CASE("ports of elements of buses are reported") {
  check_fault(subsystem("S", 1, inport("In Bus Element", 2, {{"IsBusElementPort", "on"}})),
              "S/In Bus Element: is the port of an element of a bus");
}

TEST_CASE("two conditions of one kind and two lines to one input are reported") {
  check_fault(subsystem("S", 1, block("EnablePort", "E", 2) + block("EnablePort", "F", 3)),
              "S/F: is a second EnablePort; 'E' counts alone");
  check_fault(
      number(1, "1") + number(2, "2") + sink(3) + line("1#out:1", {"3#in:1"}) + line("2#out:1", {"3#in:1"}),
      "W: has two lines to its port in:1; the last one is written");
}

TEST_CASE("a line to a block that is not there is reported, one to a block that is commented out is not") {
  check_fault(number(1, "1") + sink(3) + line("1#out:1", {"3#in:1", "999#in:1"}),
              "has a line to a block with the SID 999, which the system lacks");
  const Imported imported(ModelText{number(1, "1") + sink(3) + block("Gain", "G", 4, {{"Commented", "on"}}) +
                                    line("1#out:1", {"3#in:1", "4#in:1"})});
  CHECK_FALSE(imported.result.is_unfinished());
}

TEST_CASE("sample times of ports and atomic systems are reported, and that of a Constant is translated") {
  const auto deviations = [](const std::string& system) {
    return Imported(ModelText{system}).notes(NoteKind::deviates);
  };
  CHECK_THAT(deviations(block("SubSystem", "S", 1, {{"TreatAsAtomicUnit", "on"}, {"SystemSampleTime", "0.1"}},
                              "<System></System>")),
             Contains("S: has the sample time 0.1, which is not translated"));
  CHECK_THAT(deviations(inport("In1", 1, {{"SampleTime", "0.1"}})), Contains("In1: has the sample time 0.1"));
  CHECK_THAT(deviations(inport("In1", 1, {{"SampleTime", "-1"}})), !Contains("sample time"));
}

// The count of initial values is that of the periods, and may be that of the elements as well.
TEST_CASE("initial values of a Delay that may be those of its periods are not guessed") {
  const std::string model =
      number(1, "1") + sink(3) +
      block("Delay", "D", 2, {{"DelayLength", "3"}, {"InitialCondition", "[7 8 9]"}, {"SampleTime", "0.1"}}) +
      line("1#out:1", {"2#in:1"}) + line("2#out:1", {"3#in:1"});
  CHECK(Imported(ModelText{model}).result.is_unfinished());
}

// A counter that inherits the rate of the Constant counts 11 ticks of 0.1 s in 1 s.
TEST_CASE("blocks behind a Constant with a sample time have its rate") {
  const std::string counter = block("Constant", "One", 1, {{"Value", "1"}, {"SampleTime", "0.1"}}) +
                              block("Sum", "Add", 2, {{"Inputs", "++"}}) +
                              block("UnitDelay", "Last", 3, {{"SampleTime", "-1"}}) + sink(4) +
                              line("1#out:1", {"2#in:1"}) + line("2#out:1", {"3#in:1", "4#in:1"}) +
                              line("3#out:1", {"2#in:2"});
  const Imported imported(ModelText{counter});
  CHECK(imported.last("y") == 11.0);
}

TEST_CASE("two senders of one tag are reported where they have one scope") {
  const std::string one = number(1, "1") + line("1#out:1", {"2#in:1"}),
                    two = number(1, "1") + line("1#out:1", {"2#in:1", "3#in:1"});
  check_fault(two + sender(2, "local") + sender(3, "local"), "Send3: sends the tag 'a', as 'Send2' does");
  const std::string inner = subsystem("S", 4, sender(5, "global"));
  check_fault(two + sender(2, "global") + inner, "S/Send5: sends the tag 'a', as 'Send2' does");
  CHECK_FALSE(Imported(ModelText{one + sender(2, "global") + subsystem("S", 4, sender(5, "local"))})
                  .result.is_unfinished());
}

TEST_CASE("a tag is that of the nearest scope, and a local one is not read elsewhere") {
  const std::string reader = block("From", "From", 30, {{"GotoTag", "a"}}) + block("Outport", "Out1", 31) +
                             line("30#out:1", {"31#in:1"});
  const auto imported = [&](const std::string& visibility, const std::string& inside) {
    return Imported(ModelText{number(1, "4") + sender(2, visibility) + line("1#out:1", {"2#in:1"}) +
                              subsystem("S", 3, reader + inside) + sink(4) + line("3#out:1", {"4#in:1"})});
  };
  const std::string own = number(40, "7") + sender(41, "local") + line("40#out:1", {"41#in:1"});
  CHECK(imported("global", "").last("y") == 4.0);
  CHECK(imported("global", own).last("y") == 7.0);
  const Imported other = imported("local", "");
  CHECK_THAT(other.notes(NoteKind::deviates),
             Contains("S/From: reads the tag 'a', which 'Send2' does not send to this system"));
  const std::string scope = block("GotoTagVisibility", "V", 5, {{"GotoTag", "a"}});
  CHECK_FALSE(Imported(ModelText{number(1, "4") + sender(2, "scoped") + scope + line("1#out:1", {"2#in:1"}) +
                                 subsystem("S", 3, reader) + sink(4) + line("3#out:1", {"4#in:1"})})
                  .result.is_unfinished());
}

}  // namespace stepwire::simulink
