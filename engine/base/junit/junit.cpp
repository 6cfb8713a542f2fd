#include "engine/base/junit/junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <pugixml.hpp>
#include <sstream>

#include "engine/base/text/characters.hpp"

namespace stepwire::junit {

namespace {

void set(pugi::xml_node& node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(text::visible(value).c_str());
}

std::string count_of(const std::vector<TestSuite>& suites, std::optional<Result> result) {
  std::size_t count = 0;
  for (const TestSuite& suite : suites)
    count += static_cast<std::size_t>(std::ranges::count_if(
        suite.cases, [&](const TestCase& one) { return !result || one.result == *result; }));
  return std::to_string(count);
}

double seconds_of(const std::vector<TestSuite>& suites) {
  double seconds = 0.0;
  for (const TestSuite& suite : suites) seconds += suite.seconds;
  return seconds;
}

void set_counts(pugi::xml_node& node, const std::vector<TestSuite>& suites) {
  set(node, "tests", count_of(suites, std::nullopt));
  set(node, "failures", count_of(suites, Result::failed));
  set(node, "errors", count_of(suites, Result::error));
}

void add_case(pugi::xml_node& suite, const std::string& of, const TestCase& one) {
  pugi::xml_node node = suite.append_child("testcase");
  set(node, "classname", of);
  set(node, "name", one.name);
  if (one.result == Result::passed) return;
  const char* const element = one.result == Result::failed  ? "failure"
                              : one.result == Result::error ? "error"
                                                            : "skipped";
  pugi::xml_node reason = node.append_child(element);
  set(reason, "message", one.message);
  if (one.result != Result::skipped) set(reason, "type", one.result == Result::failed ? "claim" : "fault");
}

}  // namespace

std::string junit_text(const std::vector<TestSuite>& suites) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  pugi::xml_node root = document.append_child("testsuites");
  set(root, "name", "stepwire");
  set(root, "time", fmt::format("{:.6f}", seconds_of(suites)));
  set_counts(root, suites);
  for (const TestSuite& suite : suites) {
    pugi::xml_node node = root.append_child("testsuite");
    set(node, "name", suite.name);
    set_counts(node, {suite});
    set(node, "skipped", count_of({suite}, Result::skipped));
    set(node, "time", fmt::format("{:.6f}", suite.seconds));
    for (const TestCase& one : suite.cases) add_case(node, suite.name, one);
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace stepwire::junit
