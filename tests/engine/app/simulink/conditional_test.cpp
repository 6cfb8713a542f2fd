// Subsystems that run on condition: their outputs while they are off, and cases.
#include <catch2/catch.hpp>

#include "tests/engine/app/simulink/slx.hpp"
#include "tests/support/run_text.hpp"

using Catch::Contains;

namespace stepwire::simulink {

namespace {

std::string sink(int sid, const std::string& name) {
  return block("ToWorkspace", "Sink" + std::to_string(sid), sid, {{"VariableName", name}});
}

/// A gain of the time that is on from 0.4 s to 0.6 s, with two outputs of these parameters.
Imported gated(const P& first, const P& second, const P& callbacks = {}) {
  P other = second;
  other["Port"] = "2";
  const std::string inside = block("EnablePort", "Enable", 20) + block("Inport", "In1", 21) +
                             block("Gain", "Gain", 22) + block("Outport", "One", 23, first) +
                             block("Outport", "Two", 24, other) + line("21#out:1", {"22#in:1"}) +
                             line("22#out:1", {"23#in:1", "24#in:1"});
  ModelText model{time_source(1) +
                  reference("simulink/Logic and Bit Operations/Interval Test", "On", 2,
                            {{"lowlimit", "0.395"}, {"uplimit", "0.605"}}) +
                  block("SubSystem", "S", 3, {}, "<System>" + inside + "</System>") + sink(4, "one") +
                  sink(5, "two") + line("1#out:1", {"2#in:1", "3#in:1"}) + line("2#out:1", {"3#enable"}) +
                  line("3#out:1", {"4#in:1"}) + line("3#out:2", {"5#in:1"})};
  model.callbacks = callbacks;
  return Imported(model);
}

/// Checks a column before the subsystem is on, while it is on, and after that.
void check(const Imported& imported, const std::string& name, double before, double on, double after) {
  const table::Table table = imported.run();
  const std::vector<double> values = column(table, name);
  INFO(name);
  CHECK(values.at(20) == Approx(before));
  CHECK(values.at(50) == Approx(on));
  CHECK(values.at(90) == Approx(after));
}

}  // namespace

TEST_CASE("an output that holds has its initial value up to the first run") {
  const Imported imported = gated({{"InitialOutput", "7"}}, {});
  CHECK_FALSE(imported.result.is_unfinished());
  check(imported, "one", 7.0, 0.5, 0.6);
  check(imported, "two", 0.0, 0.5, 0.6);
}

TEST_CASE("one output of a subsystem is reset while the other holds") {
  const Imported imported =
      gated({{"OutputWhenDisabled", "reset"}, {"InitialOutput", "-2"}}, {{"InitialOutput", "3"}});
  CHECK_FALSE(imported.result.is_unfinished());
  check(imported, "one", -2.0, 0.5, -2.0);
  check(imported, "two", 3.0, 0.5, 0.6);
}

TEST_CASE("outputs that are all reset to numbers are a key of the part") {
  const Imported imported =
      gated({{"OutputWhenDisabled", "reset"}, {"InitialOutput", "-2"}}, {{"OutputWhenDisabled", "reset"}});
  CHECK_THAT(imported.text(), Contains("outputs: reset"));
  CHECK_THAT(imported.part("S.yaml"), Contains("safe: -2"));
  check(imported, "one", -2.0, 0.5, -2.0);
  check(imported, "two", 0.0, 0.5, 0.0);
}

TEST_CASE("an initial output may be a variable of the model") {
  const Imported imported =
      gated({{"OutputWhenDisabled", "reset"}, {"InitialOutput", "2*k"}}, {}, {{"PreLoadFcn", "k = 4;"}});
  CHECK_FALSE(imported.result.is_unfinished());
  check(imported, "one", 8.0, 0.5, 8.0);
}

TEST_CASE("an initial output that cannot be read is said, and the import is not finished") {
  const Imported imported = gated({{"InitialOutput", "myfun(2)"}}, {});
  CHECK(imported.result.is_unfinished());
  CHECK_THAT(imported.notes(NoteKind::deviates),
             Contains("S: its output One is myfun(2) before its first run"));
}

TEST_CASE("cases may be negative, lists and ranges, and cut off the fraction of their input") {
  const auto action = [](const char* name, int sid, const char* value) {
    const std::string at = std::to_string(sid);
    return block("SubSystem", name, sid, {},
                 "<System>" + block("ActionPort", "Action", sid + 1) + number(sid + 2, value) +
                     block("Outport", "Out1", sid + 3) +
                     line(std::to_string(sid + 2) + "#out:1", {std::to_string(sid + 3) + "#in:1"}) +
                     "</System>");
  };
  const auto chosen = [&](const std::string& cases, const std::string& input) {
    const ModelText model{
        number(1, input) + block("SwitchCase", "Case", 2, {{"CaseConditions", cases}, {"Ports", "[1, 3]"}}) +
        action("A", 10, "1") + action("B", 20, "2") + action("C", 30, "3") +
        block("Merge", "Merge", 40, {{"Ports", "[3, 1]"}}) + sink(41, "y") + line("1#out:1", {"2#in:1"}) +
        line("2#out:1", {"10#ifaction"}) + line("2#out:2", {"20#ifaction"}) +
        line("2#out:3", {"30#ifaction"}) + line("10#out:1", {"40#in:1"}) + line("20#out:1", {"40#in:2"}) +
        line("30#out:1", {"40#in:3"}) + line("40#out:1", {"41#in:1"})};
    return Imported(model).last("y");
  };
  const std::string mixed = "{-1, [2 3]}";
  CHECK(chosen(mixed, "-1") == 1.0);
  CHECK(chosen(mixed, "-1.7") == 1.0);
  CHECK(chosen(mixed, "-2") == 3.0);
  CHECK(chosen(mixed, "2") == 2.0);
  CHECK(chosen(mixed, "3.9") == 2.0);
  CHECK(chosen(mixed, "0") == 3.0);
  CHECK(chosen("{1:3, 10}", "2") == 1.0);
  CHECK(chosen("{1:3, 10}", "10") == 2.0);
  CHECK(chosen("{[4 -5] 7}", "-5") == 1.0);
  CHECK(chosen("{[4 -5] 7}", "7") == 2.0);
  CHECK(chosen("{1 -2}", "-2") == 2.0);
  CHECK(chosen("{1 - 2, 5}", "-1") == 1.0);
  CHECK(chosen("{1e1, 5}", "10") == 1.0);
}

TEST_CASE("cases that cannot be read make a placeholder") {
  const Imported imported(
      ModelText{number(1, "1") +
                block("SwitchCase", "Case", 2, {{"CaseConditions", "{1, myfun(2)}"}, {"Ports", "[1, 2]"}}) +
                line("1#out:1", {"2#in:1"})});
  CHECK_THAT(imported.notes(NoteKind::placeholder), Contains("Case: SwitchCase is not translated"));
}

}  // namespace stepwire::simulink
