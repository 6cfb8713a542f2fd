#include "engine/base/result/record.hpp"

#include <catch2/catch.hpp>
#include <limits>

namespace stepwire::result {

/// Item of a list.
struct Shelf {
  std::string label;
  double height = 0.0;
};

/// Record with a field of every type.
struct Cupboard {
  bool is_open = true;
  int doors = 2;
  double width = std::numeric_limits<double>::infinity();
  std::optional<std::string> owner{};
  std::complex<double> pole{-1.0, 0.5};
  std::array<double, 2> range{0.25, 4.0};
  Eigen::MatrixXd turns = Eigen::MatrixXd::Identity(2, 2);
  std::vector<Shelf> shelves{{"low", 0.5}, {"high", 1.5}};
  Map<double> weights{{"cup", 0.2}};
  std::optional<unit::Dimension> dimension = unit::parse_unit("mm")->dimension;
  std::string note{};
};

static void declare(Record<Shelf>& is) {
  is.named("Shelf", "A shelf.");
  is.field("label", &Shelf::label, "label");
  is.field("height", &Shelf::height, "height above the floor", "m");
}

static void declare(Record<Cupboard>& is) {
  using Is = Cupboard;
  is.named("Cupboard", "A cupboard.");
  is.field("open", &Is::is_open, "true if it is open");
  is.field("doors", &Is::doors, "number of doors");
  is.field("width", &Is::width, "width", "m");
  is.field("owner", &Is::owner, "owner; null if unknown");
  is.field("pole", &Is::pole, "pole");
  is.field("range", &Is::range, "range");
  is.field("turns", &Is::turns, "matrix");
  is.field("shelves", &Is::shelves, "shelves");
  is.field("weights", &Is::weights, "weight of each item", "kg");
  is.field("unit", &Is::dimension, "unit");
  is.omitted(
      "note", [](const Is& of) { return text_if_any(of.note); }, "note");
  is.field(
        "p99.9", [](const Is&) { return "fast"; }, "a word of a list")
      .choices = {"fast", "slow"};
}

TEST_CASE("a record has its fields in JSON in the order of their declaration") {
  CHECK(
      json_of(Cupboard{}).text(-1) ==
      R"({"open":true,"doors":2,"width":null,"owner":null,"pole":[-1.0,0.5],"range":[0.25,4.0],)"
      R"("turns":[[1.0,0.0],[0.0,1.0]],"shelves":[{"label":"low","height":0.5},{"label":"high","height":1.5}],)"
      R"("weights":{"cup":0.2},"unit":"m","p99.9":"fast"})");
}

TEST_CASE("a field that is omitted without a value is in JSON with one") {
  Cupboard cupboard;
  cupboard.note = "of oak";
  const json::Json json = json_of(cupboard);
  REQUIRE(json.find("note"));
  CHECK(*json.find("note")->as_text() == "of oak");
}

TEST_CASE("records of TypeScript follow from the declaration, the contained ones first") {
  CHECK(typescript_of({&record_type<Cupboard>()}) == R"(
/** A shelf. */
export interface Shelf {
  /** label */
  label: string;
  /** height above the floor [m] */
  height: number | null;
}

/** A cupboard. */
export interface Cupboard {
  /** true if it is open */
  open: boolean;
  /** number of doors */
  doors: number;
  /** width [m] */
  width: number | null;
  /** owner; null if unknown */
  owner: string | null;
  /** pole */
  pole: [number, number];
  /** range */
  range: [number | null, number | null];
  /** matrix */
  turns: (number | null)[][];
  /** shelves */
  shelves: Shelf[];
  /** weight of each item [kg] */
  weights: Record<string, number | null>;
  /** unit */
  unit: string | null;
  /** note */
  note?: string;
  /** a word of a list */
  "p99.9": "fast" | "slow";
}
)");
}

TEST_CASE("classes of a Python stub follow from the declaration") {
  CHECK(python_stub_of({&record_type<Cupboard>()}) == R"(
class Shelf(Record):
    """A shelf."""
    label: str
    """label"""
    height: float
    """height above the floor [m]"""

class Cupboard(Record):
    """A cupboard."""
    open: bool
    """true if it is open"""
    doors: int
    """number of doors"""
    width: float
    """width [m]"""
    owner: str
    """owner; null if unknown"""
    pole: complex
    """pole"""
    range: tuple[float, float]
    """range"""
    turns: list[list[float]]
    """matrix"""
    shelves: list[Shelf]
    """shelves"""
    weights: dict[str, float]
    """weight of each item [kg]"""
    unit: str
    """unit"""
    note: str
    """note"""
    p99_9: str
    """a word of a list"""
)");
}

TEST_CASE("types of fields are described in words") {
  std::vector<std::string> words;
  for (const FieldType& field : record_type<Cupboard>().fields) words.push_back(type_text(field.type));
  CHECK(words == std::vector<std::string>{"flag", "count", "number", "text or null", "[re, im]",
                                          "[low, high]", "list of rows", "list of Shelf", "number by name",
                                          "text or null", "text or null", "text"});
}

}  // namespace stepwire::result
