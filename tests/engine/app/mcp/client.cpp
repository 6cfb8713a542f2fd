#include "tests/engine/app/mcp/client.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "engine/base/subprocess/process.hpp"

using nlohmann::json;

std::vector<json> Client::exchange(const std::vector<std::string>& messages,
                                   const std::vector<std::string>& options) const {
  std::string input =
      R"({"jsonrpc":"2.0","id":"hello","method":"initialize","params":{"protocolVersion":"2025-06-18",)"
      R"("capabilities":{},"clientInfo":{"name":"test","version":"1"}}})"
      "\n"
      R"({"jsonrpc":"2.0","method":"notifications/initialized"})"
      "\n";
  for (const std::string& message : messages) input += message + "\n";
  std::vector<std::string> command{STEPWIRE_PROGRAM, "mcp"};
  command.insert(command.end(), options.begin(), options.end());
  const auto done = stepwire::subprocess::run_process({.command = command, .input = input});
  INFO(done.errors);
  REQUIRE(done.succeeded());
  std::vector<json> answers;
  std::istringstream lines(done.output);
  for (std::string line; std::getline(lines, line);) answers.push_back(json::parse(line));
  REQUIRE(!answers.empty());
  CHECK(answers.front()["result"]["serverInfo"]["name"] == "stepwire");
  answers.erase(answers.begin());
  return answers;
}

json Client::call(const std::string& tool, json arguments) const {
  if (!arguments.contains("folder")) arguments["folder"] = folder_.path("");
  const json request{{"jsonrpc", "2.0"},
                     {"id", 1},
                     {"method", "tools/call"},
                     {"params", {{"name", tool}, {"arguments", arguments}}}};
  const std::vector<json> answers = exchange({request.dump()});
  REQUIRE(answers.size() == 1);
  INFO(answers.front().dump(1));
  REQUIRE(answers.front().contains("result"));
  return answers.front()["result"];
}

json Client::on_text(const std::string& tool, const std::string& text, json more) const {
  more["text"] = text;
  return call(tool, more)["structuredContent"];
}

json Client::values(const std::string& text, json more) const {
  const json data = on_text("claims", text, more);
  INFO(data.dump(1));
  REQUIRE(data["exit"] == 0);
  json values = json::object();
  for (const json& claim : data["result"][0]["claims"]) {
    CHECK(claim["holds"] == true);
    values[claim["that"].get<std::string>()] = claim["value"];
  }
  REQUIRE(!values.empty());
  return values;
}

std::string diagram(const std::string& step, const std::string& stop, const std::string& rest,
                    const std::string& solver) {
  const std::string head = "stepwire: 1\nstep: " + step + "\nstop: " + stop + "\n";
  return head + (solver.empty() ? "" : "solver: " + solver + "\n") + rest;
}
