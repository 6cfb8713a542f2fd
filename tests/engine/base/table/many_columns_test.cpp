// Readers at sizes that a reader of quadratic cost does not finish.
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/base/csv/read_record.hpp"
#include "engine/base/fmi/description.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/mat/mat_file.hpp"
#include "engine/base/mat/mat_names.hpp"
#include "engine/base/mcap/channel_rows.hpp"
#include "engine/base/table/record_table.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::table {

using Catch::Contains;

namespace {

constexpr int many = 300'000;

/// {"k0":1,"k1":1,...}
std::string object_of(int keys) {
  std::string text = "{";
  for (int i = 0; i < keys; ++i) text += (i > 0 ? ",\"k" : "\"k") + std::to_string(i) + "\":1";
  return text + "}";
}

}  // namespace

TEST_CASE("a JSON object of many keys keeps them in their order, each once") {
  json::Json object = json::Json::parse(object_of(many));
  REQUIRE(object.members().size() == many);
  CHECK(object.members()[many - 1].first == "k299999");
  CHECK(object.text(-1) == object_of(many));
  for (int i = 0; i < many; ++i) object.set("k" + std::to_string(i), i);
  CHECK(object.members().size() == many);
  CHECK(object.find("k299999")->as_number() == 299'999.0);
  CHECK(object.find("k300000") == nullptr);
  CHECK(json::Json::parse(R"({"a": 1, "b": 2, "a": 3})").text(-1) == R"({"a":3,"b":2})");
}

TEST_CASE("a message of an MCAP file ends at the first column that is too many") {
  mcap::ChannelRows rows("signals", nullptr);
  rows.add(std::string_view(object_of(1000)), 0);
  CHECK(rows.columns() == 1001);
  CHECK_THROWS_WITH(rows.add(std::string_view(object_of(many)), 0), "'signals' has more than 20000 columns");
  CHECK(rows.columns() == mcap::ChannelRows::max_columns);
}

TEST_CASE("a CSV file of many columns is read, and so is one with many empty lines") {
  const Scratch scratch;
  std::string head = "time", row = "0";
  for (int i = 0; i < many; ++i) head += ",c" + std::to_string(i), row += ",1";
  CHECK(read_csv(scratch.file("wide.csv", head + "\n" + row + "\n")).columns.size() == many + 1);
  const RecordTable gaps =
      csv::read_record(scratch.file("gaps.csv", "time,x\n0,1\n" + std::string(many, '\n') + "1,2\n"));
  REQUIRE(gaps.rows() == 2);
  CHECK(gaps.columns[1].values.back() == 2.0);
}

TEST_CASE("empty lines of a CSV file of many columns fill no memory", "[full]") {
  const Scratch scratch;
  std::string head = "time";
  for (int i = 0; i < 20'000; ++i) head += ",c" + std::to_string(i);
  const std::string path = scratch.file("a.csv", head + std::string(20'000, '\n') + "x\n");
  CHECK_THROWS_WITH(csv::read_record(path), Contains("a.csv:20001: 1 value where the header names 20001"));
}

TEST_CASE("many columns of one name have names that MATLAB allows, and come back from its file") {
  const std::vector<std::string> same(100'000, std::string(80, 'a'));
  const std::vector<std::string> names = mat::matlab_names(same);
  CHECK(names[1] == std::string(61, 'a') + "_2");
  CHECK(names[8] == std::string(61, 'a') + "_9");
  CHECK(names[9] == std::string(60, 'a') + "_10");
  CHECK(names.back() == std::string(56, 'a') + "_100000");
  CHECK(mat::matlab_names({"a_2", "a", "a", "a"}) == std::vector<std::string>{"a_2", "a", "a_3", "a_4"});
  Table table;
  for (int i = 0; i < 50'000; ++i) table.columns.push_back({"c." + std::to_string(i), "m", {1.0 * i}});
  const Scratch scratch;
  mat::write_mat(scratch.path("a.mat"), table);
  const Table back = mat::read_mat(scratch.path("a.mat"));
  REQUIRE(back.columns.size() == table.columns.size());
  CHECK(back.columns.back().name == "c.49999");
  CHECK(back.columns.back().values == std::vector<double>{49'999.0});
}

TEST_CASE("a unit of many inputs, outputs, states and arrays is described in one pass") {
  constexpr int count = 50'000;
  std::string variables, structure;
  for (int i = 0; i < count; ++i) {
    const auto number = [&](int group) { return std::to_string(group * count + i); };
    const auto variable = [&](int group, const std::string& more) {
      variables +=
          "<Float64 name=\"v" + number(group) + "\" valueReference=\"" + number(group) + "\" " + more;
    };
    variable(0, "causality=\"input\" start=\"0\"/>");
    variable(1, "causality=\"output\"/>");
    variable(2, "causality=\"local\"/>");
    variable(3, "causality=\"local\" derivative=\"" + number(2) + "\"/>");
    variable(4, "causality=\"local\"><Dimension valueReference=\"250000\"/></Float64>");
    structure += "<Output valueReference=\"" + number(1) + "\" dependencies=\"" +
                 (i % 2 == 0 ? number(0) : "") + "\"/>";
    structure += "<ContinuousStateDerivative valueReference=\"" + number(3) + "\"/>";
  }
  variables += "<UInt64 name=\"n\" valueReference=\"250000\" causality=\"structuralParameter\" start=\"3\"/>";
  const fmi::Description unit = fmi::read_description(
      "<fmiModelDescription fmiVersion=\"3.0\" modelName=\"m\" instantiationToken=\"t\"><CoSimulation "
      "modelIdentifier=\"m\"/><ModelVariables>" +
      variables + "</ModelVariables><ModelStructure>" + structure +
      "</ModelStructure></fmiModelDescription>");
  CHECK(unit.state_count == count);
  CHECK(unit.states.back() == 3 * count - 1);
  CHECK(unit.find(5 * count - 1)->size == 3);
  for (int i = 0; i < count; ++i)
    if (unit.feeds_through(*unit.find(static_cast<std::uint32_t>(i))) != (i % 2 == 0)) FAIL(i);
}

}  // namespace stepwire::table
