#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

const std::string step =
    "time [s],gate,f [N]\n0,0,1\n0.001,0,1\n0.002,1,2\n0.003,1,2\n0.004,1,2\n0.005,1,2\n";
const std::string late =
    "time [s],gate,f [N]\n0,0,1\n0.001,0,1\n0.002,0,1\n0.003,1,2\n0.004,1,2\n0.005,1,2.1\n";

}  // namespace

TEST_CASE("compare agrees on csv, mat and h5 of a run, and on its folder") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out", "--files", "csv,mat,h5"}).code == 0);
  for (const char* other : {"out/signals.csv", "out/signals.mat", "out/signals.h5"}) {
    const Done done = run_program(folder, {"compare", "out", other});
    INFO(done.out << done.err);
    CHECK(done.code == 0);
    CHECK_THAT(done.out, Contains("lag: no difference"));
  }
}

TEST_CASE("compare with jitter prints the two values that give the difference") {
  const Scratch folder;
  folder.file("a.csv", "time [s],f\n0,0\n1,0\n2,10\n3,10\n4,10\n");
  folder.file("b.csv", "time [s],f\n0,0\n1,0\n2,0\n3,7.5\n4,7.5\n");
  const Done done = run_program(folder, {"compare", "a.csv", "b.csv", "--jitter", "1 s"});
  CHECK(done.code == 1);  // 10 at 2 s; b has values between 0 and 7.5 from 1 s to 3 s
  CHECK_THAT(done.out, Contains("differs by 2.5") && Contains("at 2 s, 10 and 7.5"));
}

TEST_CASE("compare takes tolerances and jitter by signal, and its exit code is the verdict") {
  const Scratch folder;
  folder.file("a.csv", step);
  folder.file("b.csv", late);
  CHECK(run_program(folder, {"compare", "a.csv", "b.csv"}).code == 1);
  CHECK(run_program(folder, {"compare", "a.csv", "b.csv", "--jitter", "1 ms"}).code == 1);
  CHECK(run_program(folder, {"compare", "a.csv", "b.csv", "--jitter", "1 ms", "--only", "gate"}).code == 0);
  CHECK(
      run_program(folder, {"compare", "a.csv", "b.csv", "--jitter", "1 ms", "--absolute", "f=0.11 N"}).code ==
      0);
  CHECK(run_program(folder, {"compare", "a.csv", "b.csv", "--jitter", "1 ms", "--relative", "f=4 %"}).code ==
        1);
  CHECK(run_program(folder, {"compare", "--only", "gate", "--jitter", "1 ms", "a.csv", "b.csv"}).code == 0);
  const Done unknown = run_program(folder, {"compare", "a.csv", "b.csv", "--jitter", "1 mm"});
  CHECK(unknown.code == 2);
  CHECK_THAT(unknown.err, Contains("no time"));
  const Done missing = run_program(folder, {"compare", "a.csv", "none.csv"});
  CHECK(missing.code == 2);
  CHECK_THAT(missing.err, Contains("none.csv"));
}

TEST_CASE("a file of accepted differences names the baseline and tolerances by pattern") {
  const Scratch folder;
  folder.file("a.csv", step);
  folder.file("b.csv", late);
  folder.file("accepted.yaml",
              "baseline: a.csv\nsignals:\n  \"*\": {jitter: 1 ms}\n  f: {absolute: 0.11 N}\n");
  CHECK(run_program(folder, {"compare", "b.csv", "--within", "accepted.yaml"}).code == 0);
  folder.file("wrong.yaml", "baseline: a.csv\nsignals:\n  f: {jitter: 1, absolut: 0.1 N}\n");
  const Done wrong = run_program(folder, {"compare", "b.csv", "--within", "wrong.yaml"});
  CHECK(wrong.code == 2);
  CHECK_THAT(wrong.err, Contains("wrong.yaml:3:") && Contains("absolut") && Contains("'1' is no time"));
}

TEST_CASE("compare --json has the worst signal first, and -o draws it") {
  const Scratch folder;
  folder.file("a.csv", step);
  folder.file("b.csv", late);
  const Done done =
      run_program(folder, {"compare", "a.csv", "b.csv", "--json", "-o", "c.svg", "--jitter", "gate=1 ms"});
  CHECK(done.code == 1);
  const auto result = nlohmann::json::parse(done.out);
  CHECK(result["signals"][0]["name"] == "f");
  CHECK(result["signals"][0]["difference"] == 1.0);
  CHECK(result["signals"][0]["time"] == 0.002);
  CHECK(result["signals"][1]["agrees"] == true);
  CHECK_THAT(content_of(folder.path("c.svg")), Contains("<svg"));
}
