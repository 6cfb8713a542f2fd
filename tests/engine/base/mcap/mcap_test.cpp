// Written files are read back, and damage is reported; mcap.test.mjs has another reader.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/mcap/bytes.hpp"
#include "engine/base/mcap/mcap_read.hpp"
#include "engine/base/mcap/mcap_writer.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::mcap {

using Catch::Contains;

namespace {

using Values = std::vector<double>;
const Values times{0.0, 0.1, 0.2}, positions{1.0 / 3.0, -0.0, 1e300};

void write_runs(const std::string& path, const std::vector<table::RunView>& runs) {
  McapWriter writer(path, "A cart");
  for (const table::RunView& run : runs) writer.add(run);
  writer.finish();
}

std::vector<table::RunView> one_run() {
  return {{"",
           {},
           {{"time", "s", times}, {"cart.position", "mm", positions}, {"push", "N", times}, {"cart.x.y", "", times},
            {"push.2", "N", positions}, {"a \"b\"", "", times}}}};
}

std::string refusal(const std::string& path) {
  try {
    read_mcap(path);
  } catch (const table::TableError& error) {
    return error.what();
  }
  return "";
}

/// A file of one channel with these messages, in a chunk packed by what is named.
std::string file_of(const std::vector<std::string>& messages, const std::string& packed = "",
                    const std::string& encoding = "json") {
  std::string channel, records;
  append(channel, std::uint16_t{7});
  append(channel, std::uint16_t{0});
  append_sized(channel, "/imu");
  append_sized(channel, encoding);
  append_sized(channel, "");
  records = record(Kind::channel, channel);
  std::uint64_t time = 5'000'000'000;
  for (const std::string& message : messages) {
    std::string content;
    append(content, std::uint16_t{7});
    append(content, std::uint32_t{0});
    append(content, time);
    append(content, time);
    records += record(Kind::message, content + message);
    time += 250'000'000;
  }
  std::string chunk(24, '\0');
  append(chunk, std::uint32_t{0});
  append_sized(chunk, packed);
  append(chunk, static_cast<std::uint64_t>(records.size()));
  return std::string(magic) + record(Kind::header, std::string(8, '\0')) + record(Kind::chunk, chunk + records) +
         record(Kind::data_end, std::string(4, '\0')) + std::string(magic);
}

}  // namespace

TEST_CASE("a run comes back from an MCAP file with its names, units and bits") {
  const Scratch scratch;
  write_runs(scratch.path("a.mcap"), one_run());
  const table::RecordTable back = read_mcap(scratch.path("a.mcap"));
  REQUIRE(back.columns.size() == 6);
  const std::vector<table::RunView> written = one_run();
  for (const table::SeriesView& series : written.front().series) {
    INFO(series.name);
    REQUIRE(back.find(series.name) != nullptr);
    CHECK(back.find(series.name)->unit == series.unit);
    CHECK(back.find(series.name)->values == Values(series.values.begin(), series.values.end()));
  }
}

TEST_CASE("runs of a sweep are channels, and numbers that are none are nan") {
  const Scratch scratch;
  const Values odd{INFINITY, NAN, 2.0};
  write_runs(scratch.path("a.mcap"), {{"run-1", {{"mass", "kg", 2.0}}, {{"time", "s", times}, {"x", "m", times}}},
                                      {"run-2", {{"mass", "kg", 3.0}}, {{"time", "s", times}, {"x", "m", odd}}}});
  const table::RecordTable back = read_mcap(scratch.path("a.mcap"));
  CHECK(back.find("run-1/x")->values == times);
  CHECK(back.find("run-2/x")->unit == "m");
  CHECK(std::isnan(back.find("run-2/x")->values[0]));
  CHECK(back.find("run-2/x")->values[2] == 2.0);
}

TEST_CASE("the same runs make the same MCAP file, over chunks, and half a one is none") {
  const Scratch scratch;
  Values many(60'000);
  std::iota(many.begin(), many.end(), 0.0);
  const std::vector<table::RunView> runs{{"", {}, {{"time", "s", many}, {"x", "", many}}}};
  write_runs(scratch.path("a.mcap"), runs);
  write_runs(scratch.path("b.mcap"), runs);
  CHECK(io::read_file(scratch.path("a.mcap")) == io::read_file(scratch.path("b.mcap")));
  CHECK(read_mcap(scratch.path("a.mcap")).find("x")->values == many);
  { McapWriter(scratch.path("c.mcap"), "").add(one_run().front()); }
  CHECK(scratch.files() == 2);
}

TEST_CASE("messages of others have their log time, lists, flags, and gaps where they lack a member") {
  const Scratch scratch;
  scratch.file("a.mcap", file_of({R"({"a":{"b":1},"on":true})", R"({"a":{"b":null},"v":[3,4],"name":"left"})"}));
  const table::RecordTable table = read_mcap(scratch.path("a.mcap"));
  CHECK(table.find("time")->values == Values{0.0, 0.25});
  CHECK(table.find("a.b")->values[0] == 1.0);
  CHECK(std::isnan(table.find("a.b")->values[1]));
  CHECK(table.find("on")->values[0] == 1.0);
  CHECK(table.find("v.2")->values[1] == 4.0);
  CHECK(table.problems.at("name") == scratch.path("a.mcap") + ": 'name' holds text, not numbers");
}

TEST_CASE("an MCAP file that cannot be read is told why in one line") {
  const Scratch scratch;
  CHECK_THAT(refusal(scratch.file("a.mcap", "time,x\n")), Contains("a.mcap: this is no MCAP file"));
  CHECK_THAT(refusal(scratch.file("b.mcap", file_of({"{}"}, "zstd"))), Contains("packed by 'zstd'"));
  CHECK_THAT(refusal(scratch.file("c.mcap", file_of({"{"}))), Contains("message 1 of '/imu' is no JSON"));
  CHECK_THAT(refusal(scratch.file("d.mcap", file_of({"x"}, "", "cdr"))), Contains("there are no JSON messages"));
  CHECK_THROWS_AS(read_mcap(scratch.path("none.mcap")), io::EnvironmentError);
}

TEST_CASE("an MCAP file that was cut off in its data is an error, and a damaged one an error or a table") {
  const Scratch scratch;
  const std::string path = scratch.path("a.mcap");
  write_runs(path, one_run());
  const std::string whole = io::read_file(path);
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole;
    const bool cut = i % 3 == 0;
    const std::size_t size = random() % (whole.size() / 2);  // the summary behind the data is not needed
    if (cut) damaged.resize(size);
    for (int k = 0; k < i % 7 && !cut; ++k) damaged[random() % whole.size()] = static_cast<char>(random());
    scratch.file("a.mcap", damaged);
    INFO(i << ": " << damaged.size() << " of " << whole.size());
    const std::string told = refusal(path);
    if (cut) CHECK_FALSE(told.empty());
    CHECK(told.find('\n') == std::string::npos);
  }
}

}  // namespace stepwire::mcap
