#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/base/data_file/data_file.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

TEST_CASE("signals are written in the kinds of files that are named, with the same bits") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out", "--files", "h5,csv,mcap"}).code == 0);
  const auto csv = stepwire::table::read_csv(folder.path("out/signals.csv"));
  CHECK_FALSE(std::filesystem::exists(folder.path("out/signals.mat")));
  for (const std::string file : {"out/signals.h5", "out/signals.mcap"}) {
    const auto other = stepwire::data_file::read_data_file(folder.path(file));
    REQUIRE(other.columns.size() == csv.columns.size());
    for (const auto& column : csv.columns) {
      CHECK(other.find(column.name)->values == column.values);
      CHECK(other.find(column.name)->unit == column.unit);
    }
  }
}

TEST_CASE("kinds of files and pictures without a folder for them are refused") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  for (const std::vector<std::string>& option :
       {std::vector<std::string>{"--files", "h5"}, {"--pictures", "png"}}) {
    const Done done = run_program(folder, {"run", "lag.yaml", option[0], option[1]});
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Contains(option[0] + " requires --out"));
  }
}

TEST_CASE("what a run of a sweep has written another diagram plays back") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml + "sweep: {tau: {values: [50 ms, 100 ms]}}\n");
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out", "--files", "csv,h5,mcap"}).code == 0);
  for (const std::string ending : {"h5", "mcap"}) {
    folder.file("back.yaml",
                "stepwire: 1\ntitle: back\nstep: 1 ms\nstop: 0.5 s\nblocks:\n  y: {block: FromFile, file: "
                "out/signals." +
                    ending +
                    ", column: run-2/lag}\nrecord: [y]\nclaims:\n"
                    "  - {that: it is the slower one, final: y, between: [0.9932, 0.9933]}\n");
    const Done done = run_program(folder, {"run", "back.yaml"});
    INFO(done.err << done.out);
    CHECK(done.code == 0);
  }
}

TEST_CASE("a run that is killed leaves the rows that it had, under a name that says so") {
  const Scratch folder;
  folder.file("long.yaml", endless_yaml);
  Call call;
  call.arguments = {"run", "long.yaml", "--out", "out", "--files", "h5"};
  call.interrupt_when = folder.path("out/signals.h5.partial");
  call.signals = {SIGKILL};
  CHECK(run_program(folder, call).code == 128 + SIGKILL);
  CHECK_FALSE(std::filesystem::exists(folder.path("out/signals.h5")));
  std::filesystem::rename(call.interrupt_when, folder.path("left.h5"));
  const auto left = stepwire::data_file::read_data_file(folder.path("left.h5"));
  REQUIRE(left.rows() > 1);
  for (std::size_t row = 0; row < left.rows(); ++row)
    CHECK(left.columns[0].values[row] == Approx(100.0 * static_cast<double>(row)));
}

TEST_CASE("a run that comes to its end leaves no part of itself, and the next one removes what was left",
          "[full]") {
  const Scratch folder;
  folder.file("long.yaml", endless_yaml);
  folder.file("lag.yaml", lag_yaml);
  const std::string partial = folder.path("out/signals.h5.partial");
  Call call;
  call.arguments = {"run", "long.yaml", "--out", "out", "--files", "h5"};
  call.interrupt_when = partial;
  CHECK(run_program(folder, call).code == 130);
  CHECK_FALSE(std::filesystem::exists(partial));
  CHECK(std::filesystem::exists(folder.path("out/signals.h5")));
  call.signals = {SIGKILL};
  run_program(folder, call);
  CHECK(std::filesystem::exists(partial));
  CHECK(run_program(folder, {"run", "lag.yaml", "--out", "out", "--files", "h5"}).code == 0);
  CHECK_FALSE(std::filesystem::exists(partial));
}

TEST_CASE("pictures are written in the kinds that are named, the same bytes each time") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const std::string pixels = "\x89PNG\r\n", page = "%PDF-";
  for (const std::string out : {"a", "b"})
    REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", out, "--pictures", "png,pdf"}).code == 0);
  CHECK_FALSE(std::filesystem::exists(folder.path("a/figure.svg")));
  for (const auto& [file, beginning] : {std::pair{"figure.png", pixels}, {"figure.pdf", page}}) {
    const std::string content = content_of(folder.path(std::string("a/") + file));
    CHECK(content.starts_with(beginning));
    CHECK(content == content_of(folder.path(std::string("b/") + file)));
  }
  CHECK_THAT(run_program(folder, {"run", "lag.yaml", "--out", "c", "--pictures", "jpg"}).err,
             Contains("does not take 'jpg'. It takes: svg, png, pdf;"));
}

TEST_CASE("a kind of file that there is not is refused with those that there are") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const Done done = run_program(folder, {"run", "lag.yaml", "--out", "out", "--files", "csv,xls"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err,
             Contains("does not take 'xls'. It takes: csv, mat, h5, mcap; several are separated by commas"));
  CHECK_FALSE(std::filesystem::exists(folder.path("out")));
}
