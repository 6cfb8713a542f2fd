#include "engine/base/junit/junit.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <pugixml.hpp>
#include <set>

namespace stepwire::junit {

namespace {

/// Attributes and children of an element in Jenkins' junit-10.xsd: those that it may and those that it must
/// have.
struct ElementRule {
  std::set<std::string> attributes, needed, children;
};

const std::map<std::string, ElementRule>& rules() {
  static const std::map<std::string, ElementRule> all{
      {"testsuites", {{"name", "time", "tests", "failures", "disabled", "errors"}, {}, {"testsuite"}}},
      {"testsuite",
       {{"name", "tests", "failures", "errors", "group", "time", "skipped", "timestamp", "hostname", "id",
         "package", "file", "log", "url", "version"},
        {"name", "tests"},
        {"testsuite", "properties", "testcase", "system-out", "system-err"}}},
      {"testcase",
       {{"name", "time", "classname", "group"},
        {"name"},
        {"skipped", "error", "failure", "rerunFailure", "system-out", "system-err"}}},
      {"failure", {{"type", "message"}, {}, {}}},
      {"error", {{"type", "message"}, {}, {}}},
      {"skipped", {{"type", "message"}, {}, {}}}};
  return all;
}

void check_element(const pugi::xml_node& node) {
  INFO(node.name());
  REQUIRE(rules().contains(node.name()));
  const ElementRule& rule = rules().at(node.name());
  for (const pugi::xml_attribute& attribute : node.attributes())
    CHECK(rule.attributes.contains(attribute.name()));
  for (const std::string& name : rule.needed) CHECK(node.attribute(name.c_str()));
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() != pugi::node_element) continue;
    CHECK(rule.children.contains(child.name()));
    check_element(child);
  }
}

const std::vector<TestSuite> suites{
    {"a & b.yaml",
     1.5,
     {{"it holds < 1 \"N\""},
      {"it fails", Result::failed, "it fails: 2 N\x01 (max x <= 1 N)\nsecond line"},
      {"it is known", Result::skipped, "reason"}}},
    {"c.yaml", 0.5, {{"the run reaches its end", Result::error, "c.yaml:3:1: no 'step'"}}}};

}  // namespace

TEST_CASE("reports in XML have the elements and attributes of Jenkins' junit-10.xsd, with right counts") {
  pugi::xml_document document;
  const std::string text = junit_text(suites);
  REQUIRE(document.load_string(text.c_str()));
  const pugi::xml_node root = document.document_element();
  CHECK(std::string(root.name()) == "testsuites");
  check_element(root);
  CHECK(root.attribute("tests").as_int() == 4);
  CHECK(root.attribute("failures").as_int() == 1);
  CHECK(root.attribute("errors").as_int() == 1);
  CHECK(root.attribute("time").as_double() == 2.0);
  const pugi::xml_node suite = root.child("testsuite");
  CHECK(std::string(suite.attribute("name").value()) == "a & b.yaml");
  CHECK(suite.attribute("skipped").as_int() == 1);
  CHECK(std::string(suite.child("testcase").attribute("name").value()) == "it holds < 1 \"N\"");
}

TEST_CASE("a report has no control characters, and the same suites give the same bytes") {
  const std::string text = junit_text(suites);
  for (const char c : text) CHECK((static_cast<unsigned char>(c) >= 32 || c == '\n'));
  CHECK(text.find("&#") == std::string::npos);
  CHECK(text == junit_text(suites));
}

}  // namespace stepwire::junit
