#include "engine/base/yaml/error.hpp"

#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/message.hpp"

#include <catch2/catch.hpp>

namespace stepwire::yaml {

namespace {

Fault fault(const std::string& file, Mark mark, const Message& message) {
  return {.place = {file, mark}, .subject = "", .message = message, .used_by = {}};
}

}  // namespace

TEST_CASE("a fault is one line of place, subject and message") {
  Fault wrong = fault("lag_step.yaml", {11, 42}, "-0.5 s is not allowed; it must be above 0");
  wrong.subject = "lag.tau";
  CHECK(wrong.text() == "lag_step.yaml:11:42: lag.tau: -0.5 s is not allowed; it must be above 0");
}

TEST_CASE("a fault of the file as a whole has no line, and one without a file no name") {
  CHECK(fault("a.yaml", {}, "no such file").text() == "a.yaml: no such file");
  CHECK(fault("", {}, "nothing to do").text() == "nothing to do");
  CHECK(fault("", {2, 3}, "wrong").text() == "2:3: wrong");
}

TEST_CASE("a fault in a part names the lines that used the part, innermost first") {
  Fault wrong = fault("part.yaml", {3, 4}, "wrong");
  wrong.used_by = {{"rig.yaml", {7, 2}}, {"main.yaml", {5, 1}}};
  CHECK(wrong.text() == "part.yaml:3:4: wrong (used by rig.yaml:7:2) (used by main.yaml:5:1)");
}

TEST_CASE("a fault is seen on one line whatever the user wrote") {
  CHECK(text::visible(fault("a\nb.yaml", {1, 1}, "'x\ny' is unknown").text()) ==
        "a\\nb.yaml:1:1: 'x\\ny' is unknown");
}

TEST_CASE("an error lists its faults in order of place, files in order of their first fault") {
  const Error error(std::vector<Fault>{fault("b", {2, 1}, "3"), fault("a", {1, 1}, "4"),
                                       fault("b", {1, 9}, "2"), fault("b", {1, 2}, "1")});
  CHECK(std::string(error.what()) == "b:1:2: 1\nb:1:9: 2\nb:2:1: 3\na:1:1: 4");
}

TEST_CASE("an error names the same fault once, but two faults of one place both") {
  const Error error(
      std::vector<Fault>{fault("a", {1, 1}, "x"), fault("a", {1, 1}, "y"), fault("a", {1, 1}, "x")});
  CHECK(error.faults().size() == 2);
}

TEST_CASE("gathered faults are thrown together, and none throw nothing") {
  Faults faults;
  CHECK_NOTHROW(faults.throw_if_any());
  faults.add(fault("a", {1, 1}, "x"));
  faults.add(fault("a", {2, 1}, "y"));
  CHECK_THROWS_WITH(faults.throw_if_any(), "a:1:1: x\na:2:1: y");
}

TEST_CASE("a near miss suggests the right name") {
  const std::vector<std::string> names{"tau", "gain", "u", "initial", "frequency"};
  CHECK(did_you_mean("tua", names).text() == "; did you mean 'tau'?");
  CHECK(did_you_mean("Tau", names).text() == "; did you mean 'tau'?");
  CHECK(did_you_mean("gian", names).text() == "; did you mean 'gain'?");
  CHECK(did_you_mean("intial", names).text() == "; did you mean 'initial'?");
  CHECK(did_you_mean("freq", names).text() == "; did you mean 'frequency'?");
  CHECK(did_you_mean("ZOH", {"Sum", "ZeroOrderHold"}).text() == "; did you mean 'ZeroOrderHold'?");
  CHECK(did_you_mean("position", {"initial_position", "mass"}).text() ==
        "; did you mean 'initial_position'?");
}

TEST_CASE("a word that is far from all names suggests nothing") {
  const std::vector<std::string> names{"tau", "gain", "u"};
  for (const std::string word : {"x", "", "amplitude", "stop", "va"})
    CHECK(did_you_mean(word, names).empty());
  CHECK(did_you_mean(std::string(1'000'000, 'x'), names).empty());
  CHECK(did_you_mean("tau", {}).empty());
}

TEST_CASE("a fault knows its cure, whatever semicolons the texts of a user have") {
  const Fault plain_one = fault("a.yaml", {1, 1}, "'x; y' is missing; x: 3");
  CHECK(plain_one.message.wrong == "'x; y' is missing");
  CHECK(plain_one.message.cure == "x: 3");
  const Fault marked =
      fault("a.yaml", {1, 1}, fault_text("{} is not allowed; it must be above {}; so", "it's; 1", 0));
  CHECK(marked.text() == "a.yaml:1:1: it's; 1 is not allowed; it must be above 0; so");
  CHECK(marked.message.wrong == "it's; 1 is not allowed");
  CHECK(marked.message.cure == "it must be above 0; so");
  CHECK(fault("a.yaml", {}, "no such file").message.cure.empty());
  const Fault near = fault("a.yaml", {}, "there is no it's; x" + did_you_mean("its", {"it"}));
  CHECK(near.message.wrong == "there is no it's; x");
  CHECK(near.message.cure == "did you mean 'it'?");
}

}  // namespace stepwire::yaml
