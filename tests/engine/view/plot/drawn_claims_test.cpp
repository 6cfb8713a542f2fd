#include "engine/view/plot/drawn.hpp"

#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::plot {
using namespace testing;

namespace {

/// The value of a claim on what the figures of a text draw.
claim::Verdict verdict_on(const std::string& figures, const std::string& claim) {
  const ReadFigures read = figures_of(figures);
  INFO(read.faults);
  REQUIRE(read.faults.empty());
  query::SymbolTable names = sample_names();
  names.drawn = drawn_quantities(read.figures, sample_names());
  const yaml::Document document = yaml::parse_document("- {that: it, " + claim + "}", "d.yaml");
  yaml::Faults faults;
  const auto claims = claim::read_claims(document.root, claim::Claim::Kind::statement, names, faults);
  INFO(all_text(faults));
  REQUIRE(faults.empty());
  const auto recordings = sample_recordings({0.0, 0.1}, 40);
  return claim::judge(claims.at(0), recordings);
}

/// The faults of a claim on what the figures of a text draw.
std::string faults_on(const std::string& figures, const std::string& claim) {
  query::SymbolTable names = sample_names();
  names.drawn = drawn_quantities(figures_of(figures).figures, sample_names());
  const yaml::Document document = yaml::parse_document("- {that: it, " + claim + "}", "d.yaml");
  yaml::Faults faults;
  claim::read_claims(document.root, claim::Claim::Kind::statement, names, faults);
  return all_text(faults);
}

const std::string two_pictures = R"(
- {plot: map, x: rig.x in mm, y: rig.v in mm/s, color: "2 * abs(push.force) in N", where: rig.x > 0}
- panels:
    - {plot: lines, x: time, y: rig.x in mm}
    - {plot: lines, x: time, y: [rig.v, $limit * rig.v]}
)";

}  // namespace

TEST_CASE("A claim on what a picture draws follows the picture and not the signal") {
  CHECK(verdict_on(two_pictures, "max: figure.color, equals: 8 N").holds);
  CHECK(verdict_on("{plot: map, x: rig.x, y: rig.v, color: push.force}", "max: figure.color, equals: 4 N")
            .holds);
}

TEST_CASE("What is drawn is named by picture, panel, channel and number, where 1 may be left out") {
  for (const char* name : {"figure.1.1.x.1", "figure.1.1.x", "figure.1.x", "figure.x"})
    CHECK(verdict_on(two_pictures, std::string("max: ") + name + ", equals: 1 mm, within: 1 nm").holds);
  for (const char* name : {"figure.2.1.y", "figure.2.y.1"})
    CHECK(verdict_on(two_pictures, std::string("max: ") + name + ", equals: 1 mm, within: 1 nm").holds);
  CHECK(verdict_on(two_pictures, "max: figure.2.2.y.2 / figure.2.2.y, equals: 0.35, within: 1e-9").holds);
}

TEST_CASE("The condition under which a row is drawn selects rows of a claim") {
  CHECK(verdict_on(two_pictures, "min: rig.x, at_least: 0 m, where: figure.where").holds);
  CHECK_FALSE(verdict_on(two_pictures, "min: rig.x, at_least: 0 m").holds);
}

TEST_CASE("The unit of what is drawn is that of its expression") {
  const ReadFigures read = figures_of(two_pictures);
  query::SymbolTable names = sample_names();
  names.drawn = drawn_quantities(read.figures, sample_names());
  yaml::Faults faults;
  const yaml::Document document =
      yaml::parse_document("- {that: it, max: figure.color, equals: 8 mm}", "d.yaml");
  claim::read_claims(document.root, claim::Claim::Kind::statement, names, faults);
  CHECK_THAT(all_text(faults), Catch::Contains("8 mm is in m, but"));
  INFO(all_text(faults));
  CHECK(faults.size() == 1);
}

TEST_CASE("A name that no picture draws is refused with its neighbours") {
  const ReadFigures read = figures_of(two_pictures);
  query::SymbolTable names = sample_names();
  names.drawn = drawn_quantities(read.figures, sample_names());
  yaml::Faults faults;
  const yaml::Document document =
      yaml::parse_document("- {that: it, max: figure.colour, at_most: 8 N}", "d.yaml");
  claim::read_claims(document.root, claim::Claim::Kind::statement, names, faults);
  CHECK(all_text(faults).find("did you mean 'figure.color'?") != std::string::npos);
}

TEST_CASE("An invariant is a claim of its own kind, which no source can disagree with") {
  yaml::Faults faults;
  const yaml::Document document =
      yaml::parse_document("- {that: it, max: rig.x, at_most: 1 m, disagrees: because}", "d.yaml");
  const auto claims =
      claim::read_claims(document.root, claim::Claim::Kind::invariant, sample_names(), faults);
  CHECK(claims.at(0).kind == claim::Claim::Kind::invariant);
  CHECK(all_text(faults).find("invariants.disagrees: an invariant always holds") != std::string::npos);
}

TEST_CASE("A claim on a figure's number of each run is one of the runs") {
  // The force is 3 N in one run and 4 N in the other: its median after Hazen is 3.5 N.
  const std::string figure = "{plot: lines, x: current, y: max(push.force)}";
  CHECK_THAT(faults_on(figure, "max: figure.y, equals: 4 N"),
             Catch::Contains("'figure.y' is one number of each run, max(push.force); a claim on it is of the "
                             "runs, as quantile_of_runs: {share: 95 %, value: figure.y}"));
  CHECK(verdict_on(figure, "quantile_of_runs: {share: 50 %, value: figure.y}, at_most: 9 N").value == 3.5);
  CHECK(verdict_on(figure, "fraction_of_runs: 2*figure.y > 7 N, equals: 50 %, within: 1 %").holds);
}

}  // namespace stepwire::plot
