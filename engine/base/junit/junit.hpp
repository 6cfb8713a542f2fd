#pragma once

#include <string>
#include <vector>

namespace stepwire::junit {

/// Outcome of a test case.
enum class Result { passed, failed, error, skipped };

struct TestCase {
  std::string name;
  Result result = Result::passed;
  std::string message{};  ///< Reason of a failure, an error or a skip.
};

/// Test cases of one file.
struct TestSuite {
  std::string name;
  double seconds = 0.0;
  std::vector<TestCase> cases{};
};

/// Returns the suites as XML, in the form of JUnit that Jenkins, GitHub and GitLab read (Jenkins'
/// junit-10.xsd). Control characters are escaped. The same suites give the same bytes.
std::string junit_text(const std::vector<TestSuite>& suites);

}  // namespace stepwire::junit
