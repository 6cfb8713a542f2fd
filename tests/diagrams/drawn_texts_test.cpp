#include "tests/diagrams/drawn_texts.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "blocks/register.hpp"
#include "engine/base/io/file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire {

namespace {

/// Loads each file of a folder of diagrams.
template <class Check>
void for_every_model(const std::string& folder, Check check) {
  static const Registry registry = blocks();
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(STEPWIRE_SOURCE_DIR) /
                                                               "diagrams" / folder)) {
    if (entry.path().extension() != ".yaml") continue;
    INFO(entry.path().string());
    check(session::load_model(registry, entry.path().string(), {}));
  }
}

/// The faults of a moving mass whose figure is the text.
std::vector<std::string> faults_of(const std::string& figure) {
  static const Registry registry = blocks();
  const Scratch folder;
  const std::string file = folder.path("mass.yaml");
  io::write_file(file,
                 "stepwire: 1\ntitle: A mass\nstep: 1 ms\nstop: 0.1 s\nsolver: rk4\nparameters: {push: "
                 "{value: 2 N, doc: force}}\n"
                 "blocks:\n  force: {block: Constant, value: $push}\n"
                 "  mass: {block: Mass, force: force, mass: 1 kg}\n"
                 "record: [force, mass.position, mass.velocity]\nfigure: " +
                     figure + "\n");
  return text_faults(session::load_model(registry, file, {}));
}

/// True if neighbours' titles, exchanged, disagree with what is drawn.
template <class Titled>
bool are_told_apart(session::LoadedModel& model, Titled& one, Titled& other) {
  std::swap(one.title, other.title);
  const bool found = !text_faults(model).empty();
  std::swap(one.title, other.title);
  return found;
}

}  // namespace

TEST_CASE("labels and titles of the thesis' figures agree with what is drawn") {
  std::size_t files = 0;
  for_every_model("thesis", [&](const session::LoadedModel& model) {
    ++files;
    for (const std::string& fault : text_faults(model)) FAIL_CHECK(fault);
    for (const std::string& label : unknown_labels(model))
      FAIL_CHECK("no quantity is known in the label " << label);
  });
  CHECK(files == 52);
}

TEST_CASE("a label with the name of another quantity, or a title with another number, is a fault") {
  CHECK(faults_of("{plot: lines, x: time in s, y: mass.position in mm, x_label: time, y_label: position}")
            .empty());
  CHECK(faults_of("{plot: lines, x: time in s, y: mass.position in mm, x_label: position, y_label: time}")
            .size() == 2);
  CHECK(faults_of("{plot: lines, x: time in s, y: force in N, y_label: torque}") ==
        std::vector<std::string>{"figure.1.1: 'torque' is drawn in 'N'"});
  CHECK(faults_of("{plot: lines, x: time in s, y: mass.position in mm, y_label: x}").size() == 1);
  CHECK(faults_of("{plot: lines, title: Pushed with 2 N, x: time in s, y: force in N}").empty());
  CHECK(faults_of("{plot: lines, title: Pushed with 3 N, x: time in s, y: force in N}").size() == 1);
}

TEST_CASE("two exchanged titles of the panels of chapter 4 are a fault") {
  std::size_t pairs = 0;
  for_every_model("thesis", [&](session::LoadedModel model) {
    if (!model.study) return;
    for (plot::Figure& figure : model.figures)
      for (std::size_t i = 0; i + 1 < figure.panels.size(); ++i) {
        plot::Panel &one = figure.panels[i], &other = figure.panels[i + 1];
        if (one.title.empty() || other.title.empty() || one.title == other.title) continue;
        ++pairs;
        CHECK(are_told_apart(model, one, other));
      }
  });
  CHECK(pairs > 30);
}

}  // namespace stepwire
