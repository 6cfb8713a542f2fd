// The Model Context Protocol: messages, schemas, limits and the folder of a call.
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <thread>

#include "engine/app/mcp/mcp_server.hpp"
#include "tests/engine/app/mcp/client.hpp"

using Catch::Contains;
using nlohmann::json;

namespace {

const std::string one =
    diagram("1 ms", "1 s", "blocks:\n  a: {block: Constant, value: 1}\nrecord: [a]\n", "");
const std::string endless =
    diagram("1 us", "1000000 s",
            "blocks:\n  a: {block: Lag, u: 1, tau: 1 s}\nrecord: {every: 1000 s, signals: [a]}\n");

std::string request(int id, const std::string& method, const json& params = json::object()) {
  return json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}}.dump();
}

json tool_named(const json& tools, const std::string& name) {
  for (const json& tool : tools)
    if (tool["name"] == name) return tool;
  return {};
}

std::string text_of(const json& result) {
  return result["content"][0]["text"];
}

}  // namespace

TEST_CASE("mcp answers by JSON-RPC, and refuses what the protocol does not have") {
  const Client client;
  const auto answers = client.exchange(
      {request(1, "ping"), "{", "[]", request(2, "nothing"), request(3, "tools/call", {{"name", "chek"}}),
       request(4, "tools/call"), R"({"jsonrpc":"2.0","method":"notifications/other"})",
       request(5, "tools/list", {{"cursor", "x"}}),
       "[" + request(6, "ping") + "," + request(7, "ping") + "]"});
  REQUIRE(answers.size() == 8);
  CHECK(answers[0] == json{{"jsonrpc", "2.0"}, {"id", 1}, {"result", json::object()}});
  const std::vector<int> codes{-32700, -32600, -32601, -32602, -32602, -32602};
  for (std::size_t i = 0; i < codes.size(); ++i) CHECK(answers[i + 1]["error"]["code"] == codes[i]);
  CHECK(answers[1]["id"].is_null());
  CHECK_THAT(answers[4]["error"]["message"].get<std::string>(), Contains("did you mean 'check'?"));
  CHECK(answers[7].size() == 2);
}

TEST_CASE("mcp speaks the version that a client asks for, or its newest") {
  const Client client;
  for (const std::string version : {"2024-11-05", "2025-03-26", "2025-06-18", "1999-01-01"}) {
    const auto answers = client.exchange({request(1, "initialize", {{"protocolVersion", version}})});
    CHECK(answers[0]["result"]["protocolVersion"] == (version[0] == '1' ? "2025-06-18" : version));
  }
}

TEST_CASE("the schemas of tools are those of the verbs' options") {
  const Client client;
  const json tools = client.exchange({request(1, "tools/list")})[0]["result"]["tools"];
  for (const char* name :
       {"check", "blocks", "format", "draw", "run", "claims", "diff", "fit", "linearize", "trim", "import"})
    CHECK(tool_named(tools, name)["inputSchema"]["type"] == "object");
  const json run = tool_named(tools, "run")["inputSchema"];
  CHECK(run["properties"]["engine"]["type"] == "string");
  CHECK(run["properties"]["set"]["items"]["type"] == "string");
  CHECK(run["properties"]["threads"]["type"] == "integer");
  CHECK(run["properties"]["coverage"]["type"] == "boolean");
  CHECK(run["additionalProperties"] == false);
  for (const char* left_out : {"blocks", "parts", "json", "mpi", "csv", "color"})
    CHECK_FALSE(run["properties"].contains(left_out));
  CHECK(tool_named(tools, "linearize")["inputSchema"]["properties"]["feedback"]["enum"] ==
        json{"negative", "positive"});
}

TEST_CASE("a wrong argument of a tool is a result with isError and the cure") {
  const Client client;
  const auto refused = [&](const std::string& tool, const json& arguments) {
    const json result = client.call(tool, arguments);
    CHECK(result["isError"] == true);
    CHECK(result["structuredContent"]["exit"] == 2);
    return text_of(result);
  };
  CHECK_THAT(refused("check", {{"fiel", "a.yaml"}}), Contains("did you mean 'file'?"));
  CHECK_THAT(refused("check", json::object()), Contains("file: is missing"));
  CHECK_THAT(refused("check", {{"text", 3}}), Contains("text: is the text of a diagram"));
  CHECK_THAT(refused("run", {{"text", one}, {"limit", -1}}), Contains("limit: is a number"));
  CHECK_THAT(refused("run", {{"text", one}, {"coverage", "yes"}}), Contains("coverage: is true or false"));
  CHECK_THAT(refused("run", {{"text", one}, {"threads", 1.5}}), Contains("threads: is a whole number"));
  CHECK_THAT(refused("run", {{"text", one}, {"file", "a.yaml"}}), Contains("not given beside 'text'"));
}

TEST_CASE("a call reads and writes below its folder alone") {
  const Client client;
  const Scratch outside;
  outside.file("secret.yaml", one);
  outside.file("secret.csv", "time [s],x\n0,1\n1,2\n");
  std::filesystem::create_symlink(outside.path("secret.yaml"), client.folder().path("link.yaml"));
  std::filesystem::create_symlink(outside.path(""), client.folder().path("link"));
  client.folder().file("own.yaml", one);
  CHECK(client.call("check", {{"file", "own.yaml"}})["isError"] == false);
  for (const std::string file : {"link.yaml", "link/secret.yaml", "../secret.yaml", "-"})
    CHECK(client.call("check", {{"file", file}})["isError"] == true);
  CHECK_THAT(text_of(client.call("check", {{"file", outside.path("secret.yaml")}})),
             Contains("absolute path"));
  for (const std::string out : {"link/out", "../out"})
    CHECK(client.call("run", {{"file", "own.yaml"}, {"out", out}})["isError"] == true);
  CHECK_FALSE(std::filesystem::exists(outside.path("out")));
}

TEST_CASE("a diagram of a call names no files outside of the folder") {
  const Client client;
  const Scratch outside;
  outside.file("secret.csv", "time [s],x\n0,1\n1,2\n");
  outside.file("secret.yaml", one);
  std::filesystem::create_symlink(outside.path("secret.csv"), client.folder().path("link.csv"));
  const auto text = [](const std::string& block) {
    return diagram("10 ms", "1 s", "blocks:\n  a: {" + block + "}\nrecord: [a]\n", "");
  };
  const std::string way = std::filesystem::relative(outside.path(""), client.folder().path("")).string();
  for (const std::string& block :
       {"diagram: " + outside.path("secret.yaml"), "diagram: " + way + "/secret.yaml",
        "block: FromFile, column: x, file: " + outside.path("secret.csv"),
        "block: FromFile, column: x, file: " + way + "/secret.csv",
        std::string("block: FromFile, column: x, file: link.csv")}) {
    INFO(block);
    const json result = client.call("run", {{"text", text(block)}});
    CHECK(result["isError"] == true);
    CHECK_THAT(text_of(result), Contains("outside of the folder of the call"));
  }
  client.folder().file("own.csv", "time [s],x\n0,1\n1,2\n");
  CHECK(client.on_text("run", text("block: FromFile, column: x, file: own.csv"))["exit"] == 0);
}

TEST_CASE("the root of a server limits the folders of calls") {
  const Client client;
  const Scratch root;
  const json params{{"name", "check"}, {"arguments", {{"folder", client.folder().path("")}, {"text", one}}}};
  const json result =
      client.exchange({request(1, "tools/call", params)}, {"--root", root.path("")})[0]["result"];
  CHECK(result["isError"] == true);
  CHECK_THAT(text_of(result), Contains("is not below"));
}

TEST_CASE("a call ends at its limit, or when it is cancelled") {
  const Client client;
  const json overdue = client.call("run", {{"text", endless}, {"limit", 0.5}});
  CHECK(overdue["isError"] == true);
  CHECK_THAT(text_of(overdue), Contains("ended after 0.5 s"));
  const json params{{"name", "run"}, {"arguments", {{"text", endless}}}};
  const auto answers =
      client.exchange({request(7, "tools/call", params),
                       R"({"jsonrpc":"2.0","method":"notifications/cancelled","params":{"requestId":7}})",
                       request(8, "ping")});
  REQUIRE(answers.size() == 1);  // a cancelled request has no answer
  CHECK(answers[0]["id"] == 8);
}

TEST_CASE("a text leaves no file in the folder, and files of a run are listed") {
  const Client client;
  const json data = client.on_text("run", one, {{"out", "out"}});
  CHECK(data["exit"] == 0);
  CHECK(data["result"][0]["file"] == "text.yaml");
  CHECK(std::ranges::count(data["files"], json("out/signals.csv")) == 1);
  CHECK(client.folder().files() == 1);
}

TEST_CASE("recorded signals are thinned to the wanted rows, with the first and the last") {
  const Client client;
  const json ramp = client.on_text(
      "run", diagram("1 ms", "1 s", "blocks:\n  a: {block: Ramp, slope: 2 m/s}\nrecord: [a]\n", ""),
      {{"rows", 5}});
  const json& signals = ramp["signals"];
  CHECK(signals["columns"] == json{"time [s]", "a [m]"});
  CHECK(signals["of"] == 1001);
  REQUIRE(signals["rows"].size() == 5);
  for (const json& row : signals["rows"]) CHECK(row[1].get<double>() == Approx(2.0 * row[0].get<double>()));
  CHECK(signals["rows"][0][0] == 0.0);
  CHECK(signals["rows"][4][0] == 1.0);
}

TEST_CASE("rows of a sweep have its words") {
  const json data = Client().on_text("run",
                                     diagram("1 s", "2 s", R"yaml(parameters: {method: forward_euler}
sweep: {method: [forward_euler, backward_euler]}
blocks:
  a: {block: DiscreteIntegrator, u: 1, method: $method}
record: [a]
)yaml",
                                             ""),
                                     {{"rows", 6}});
  INFO(data.dump(1));
  REQUIRE(data["signals"]["rows"].size() == 6);
  CHECK(data["signals"]["columns"] == json{"time [s]", "method", "a"});
  CHECK(data["signals"]["rows"][0] == json{0.0, "forward_euler", 0.0});
  CHECK(data["signals"]["rows"][5] == json{2.0, "backward_euler", 3.0});
}

TEST_CASE("a large answer is shortened with a note") {
  const Client client;
  const json data = client.on_text(
      "run",
      diagram("1 ms", "3 s", "blocks:\n  a: {block: Noise, seed: 1, deviation: [1, 1, 1]}\nrecord: [a]\n",
              ""),
      {{"rows", 2000}});
  CHECK(data.dump().size() < 120'000);
  CHECK_THAT(data["shortened"][0].get<std::string>(), Contains("of 2000 items"));
}

TEST_CASE("beside a call that runs a ping is answered; it ends when it is cancelled, and has no answer") {
  namespace mcp = stepwire::mcp;
  const stepwire::reference::VerbWords verb{
      "run", "run", "", {{{"FILE"}, "TEXT", {}, "file", true, false}}, {}};
  std::vector<json> sent;
  mcp::McpServer server(mcp::tools_of({verb}), {STEPWIRE_PROGRAM, "/"}, "1",
                        [&](const std::string& message) { sent.push_back(json::parse(message)); });
  const auto begin = std::chrono::steady_clock::now();
  std::thread serving([&] { server.run(); });
  server.post(request(1, "initialize", {{"protocolVersion", "2025-06-18"}}));
  server.post(request(2, "tools/call", {{"name", "run"}, {"arguments", {{"text", endless}}}}));
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  server.post(request(3, "ping"));  // answered beside the call
  server.post(R"({"jsonrpc":"2.0","method":"notifications/cancelled","params":{"requestId":2}})");
  server.post(request(4, "ping"));
  server.close();
  serving.join();
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
  REQUIRE(sent.size() == 3);
  CHECK(sent[0]["id"] == 1);
  CHECK(sent[1]["id"] == 3);
  CHECK(sent[2]["id"] == 4);
}

TEST_CASE("a call tells nothing of files outside of its folder") {
  const Client client;
  const std::string reads = diagram(
      "1 ms", "1 s", "blocks:\n  c: {block: FromFile, file: /etc/passwdx, column: x}\nrecord: [c]\n", "");
  const json wrong = client.call("check", {{"text", reads}});
  CHECK_THAT(text_of(wrong), Contains("outside of the folder of the call") && !Contains("did you mean"));
  const json listed = client.call("blocks", {{"name", "/etc"}});
  CHECK(listed["isError"] == true);
  CHECK_THAT(text_of(listed), Contains("outside of the folder of the call"));
}

TEST_CASE("lines of messages arrive in any pieces, and the last one may lack its end") {
  std::string bytes = "one\n\r\n  \ntwo\nthree";
  stepwire::mcp::LineReader lines([&](char* to, std::size_t) -> std::size_t {
    if (bytes.empty()) return 0;
    *to = bytes.front();
    bytes.erase(0, 1);
    return 1;
  });
  CHECK(lines.next() == "one");
  CHECK(lines.next() == "two");
  CHECK(lines.next() == "three");
  CHECK_FALSE(lines.next().has_value());
}
