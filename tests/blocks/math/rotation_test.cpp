// Reference numbers: scipy.spatial.transform.Rotation 1.10, from_euler(order in capitals, [0.3,
// -0.7, 1.1]).apply([1, -2, 0.5]), from_rotvec([1, 2, -2] / 3 * 0.9), from_quat([0.1, -0.4, 0.5, 0.8]) and
// its inv().
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

void check_turned(const std::string& how, const std::array<double, 3>& expected) {
  const table::Table table = run_text(fmt::format(R"(
step: 10 ms
stop: 10 ms
solver: euler
blocks:
  v: {{block: Constant, value: {{value: [1, -2, 0.5], unit: N}}}}
  angles: {{block: Constant, value: {{value: [0.3, -0.7, 1.1], unit: rad}}}}
  axis: {{block: Constant, value: [10, 20, -20]}}
  q: {{block: Constant, value: [0.8, 0.1, -0.4, 0.5]}}
  r: {{block: Rotate3D, u: v, {}}}
record: [r]
)",
                                                  how));
  INFO(how);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(column(table, fmt::format("r.{}", k + 1))[0] == Approx(expected[k]).epsilon(1e-14));
  CHECK(table.find("r.1")->unit == "N");
}

}  // namespace

TEST_CASE("Rotate3D turns by angles about any sequence of axes") {
  const std::pair<const char*, std::array<double, 3>> references[] = {
      {"xyz", {1.388086579222899, -0.5539743797697536, 1.7367579091917178}},
      {"xzy", {-0.6006894315237719, -1.8184246456987323, -1.257976158268147}},
      {"yxz", {2.252199099136998, 0.30988293090247054, -0.2856077502130999}},
      {"yzx", {-0.561605538360216, -1.6788930798442, -1.4546192786204877}},
      {"zxy", {1.4375808304472029, -1.604538746417441, 0.7802671127094087}},
      {"zyx", {2.087856152212464, -0.7701917069810098, -0.545583561121705}},
      {"xyx", {1.766997953838074, -1.1311443407356858, -0.9209944145073239}},
      {"xzx", {-0.10665287345904928, -1.144191663840944, -1.9822841877439823}},
      {"yxy", {1.0896230797446298, -1.9577085967745764, 0.47968593287978}},
      {"yzy", {-0.770206906018004, -2.108964791027742, -0.4572185824389524}},
      {"zxz", {2.044566079230566, 0.9568288572397121, 0.3927188378638028}},
      {"zyz", {1.330813615062652, 0.3949366909523685, 1.8228988266229884}}};
  for (const auto& [order, expected] : references)
    check_turned(fmt::format("angles: angles, order: {}", order), expected);
}

TEST_CASE("Rotate3D turns by an axis and an angle, and by a quaternion of any length, and back") {
  check_turned("axis: axis, angle: 0.9 rad",
               {-0.32989028879207927, -2.232339056101419, -0.39728420049745855});
  check_turned("quaternion: q", {1.6320754716981134, -0.6037735849056606, 1.490566037735849});
  check_turned("quaternion: q, inverse: true",
               {-0.7830188679245284, -1.9622641509433965, 0.8867924528301888});
}

TEST_CASE("Rotate3D needs something that says how") {
  CHECK(error_of("step: 1 ms\nstop: 1 ms\nsolver: euler\nblocks:\n  v: {block: Constant, value: [1, 2, 3]}\n"
                 "  r: {block: Rotate3D, u: v}\nrecord: [r]\n")
            .find("must say how") != std::string::npos);
}

TEST_CASE("A product of quaternions is Hamilton's") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 10 ms
solver: euler
blocks:
  p: {block: Constant, value: [0.7, 0.6, 0.2, -0.1]}
  q: {block: Constant, value: [0.8, 0.1, -0.4, 0.5]}
  y: {block: QuaternionProduct, left: p, right: q}
  back: {block: QuaternionProduct, left: p, right: y, inverse: true}
record: [y, back]
)");
  const double expected[] = {0.63, 0.61, -0.43, 0.01}, q[] = {0.8, 0.1, -0.4, 0.5};
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(column(table, fmt::format("y.{}", k + 1))[0] == Approx(expected[k]).margin(1e-15));
    CHECK(column(table, fmt::format("back.{}", k + 1))[0] == Approx(0.9 * q[k]).epsilon(1e-14));
  }
}

TEST_CASE("A table of three dimensions is linear along each, and goes on or holds beyond its grid") {
  // scipy.interpolate.RegularGridInterpolator with fill_value=None on sin(i + 1) (j + 1)^2 + 3 k - j k
  const std::string values =
      "[[[0.8414709848078965, 3.8414709848078967], [3.365883939231586, 5.365883939231586], "
      "[7.573238863271069, "
      "8.573238863271069], [13.463535756926344, 13.463535756926344]], [[0.9092974268256816, "
      "3.9092974268256815], "
      "[3.6371897073027264, 5.637189707302726], [8.183676841431135, 9.183676841431135], [14.548758829210906, "
      "14.548758829210904]], [[0.1411200080598672, 3.1411200080598674], [0.5644800322394689, "
      "2.564480032239469], "
      "[1.2700800725388048, 2.2700800725388053], [2.2579201289578754, 2.257920128957876]]]";
  const double at[][4] = {{0.4, 1.1, 13.0, 6.298060540901321},
                          {2.9, 4.5, 19.5, 2.8213450384726766},
                          {-1.0, 6.0, 25.0, 13.683483284485376}};
  for (const auto& row : at) {
    const table::Table table = run_text(fmt::format(
        "step: 10 ms\nstop: 10 ms\nsolver: euler\nblocks:\n  y: {{block: LookupTableND, u: [{}, {}, {}], "
        "points: "
        "[[0, 1, 3], [-1, 0, 2, 5], [10, 20]], extrapolation: linear, values: {}}}\n  h: {{block: "
        "LookupTableND, u: "
        "[{}, {}, {}], points: [[0, 1, 3], [-1, 0, 2, 5], [10, 20]], values: {}}}\nrecord: [y, h]\n",
        row[0], row[1], row[2], values, row[0], row[1], row[2], values));
    CHECK(column(table, "y")[0] == Approx(row[3]).epsilon(1e-13));
    if (row[0] == -1.0) CHECK(column(table, "h")[0] == Approx(13.463535756926344).epsilon(1e-13));
  }
}

TEST_CASE("A rotation matrix turns as Rotate3D does") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 10 ms
solver: euler
blocks:
  v: {block: Constant, value: [1, -2, 0.5]}
  angles: {block: Constant, value: {value: [0.3, -0.7, 1.1], unit: rad}}
  r: {block: RotationMatrix, angles: angles, order: xyz}
  y: {block: MatrixMultiply, a: r, b: v}
record: [y]
)");
  CHECK(table.columns[1].values[0] == Approx(1.388086579222899).epsilon(1e-14));
  CHECK(table.columns[2].values[0] == Approx(-0.5539743797697536).epsilon(1e-14));
  CHECK(table.columns[3].values[0] == Approx(1.7367579091917178).epsilon(1e-14));
}
