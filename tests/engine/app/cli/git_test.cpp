// The verbs diff, merge and git-setup, and git that calls them.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "engine/base/subprocess/process.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

const std::string cart = R"yaml(stepwire: 1
title: A cart
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  push:   {block: Sine, amplitude: 3 N, frequency: 2 Hz}
  spring: {block: Gain, u: body.position, gain: -400 N/m}
  sum:    {block: Sum, u: [push, spring]}
  body:   {block: Mass, force: sum, mass: 2 kg}
record: [body.position]
)yaml";

std::string other(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// A repository of git with a diagram, in which git calls the built program.
class Repository {
 public:
  Repository() {
    git({"init", "-q", "-b", "main"});
    git({"config", "user.email", "a@example.org"});
    git({"config", "user.name", "A"});
    REQUIRE(run_program(folder, {"git-setup", "--apply"}).code == 0);
    write(cart);
    commit();
  }

  void write(const std::string& text) const { folder.file("cart.yaml", text); }
  void commit() const {
    git({"add", "-A"});
    git({"commit", "-q", "-m", "change"});
  }
  /// Returns the outputs of git, with its exit status in `code`.
  std::string git(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"git", "-C", folder.path("")});
    const auto result = stepwire::subprocess::run_process({.command = arguments});
    code = result.status;
    return result.output + result.errors;
  }

  Scratch folder;
  mutable int code = 0;
};

}  // namespace

TEST_CASE("diff has an exit code for equal, different and unreadable files") {
  const Scratch folder;
  folder.file("a.yaml", cart);
  folder.file("b.yaml", other(cart, "2 Hz", "3 Hz"));
  folder.file("c.yaml", "# another\n" + other(cart, "1 ms", "0.001 s"));
  folder.file("d.yaml", "stepwire: [");
  const Done same = run_program(folder, {"diff", "a.yaml", "c.yaml"});
  CHECK(same.code == 0);
  CHECK(same.out.empty());
  const Done changed = run_program(folder, {"diff", "a.yaml", "b.yaml"});
  CHECK(changed.code == 1);
  CHECK_THAT(changed.out, Contains("    ~ push.frequency: 2 Hz -> 3 Hz (1.5 times)  [line 7]\n"));
  CHECK(run_program(folder, {"diff", "a.yaml", "d.yaml"}).code == 2);
  CHECK(run_program(folder, {"diff", "a.yaml", "e.yaml"}).code == 2);
  CHECK(run_program(folder, {"diff", "a.yaml", "b.yaml", "c.yaml"}).code == 2);
  CHECK(run_program(folder, {"diff", "a.yaml", "b.yaml", "--rev", "HEAD"}).code == 2);
}

TEST_CASE("diff prints the differences before a picture that fails with 3") {
  const Scratch folder;
  folder.file("a.yaml", cart);
  folder.file("b.yaml", other(cart, "2 Hz", "3 Hz"));
  Call call;
  call.arguments = {"diff", "a.yaml", "b.yaml", "-o", "c.svg"};
  call.environment["PATH"] = folder.path("");
  const Done done = run_program(folder, call);
  CHECK(done.code == 3);
  CHECK_THAT(done.out, Contains("~ push.frequency: 2 Hz -> 3 Hz"));
  CHECK_THAT(done.err, Contains("node is not installed"));
}

TEST_CASE("the picture of diff marks the blocks that use a changed parameter") {
  const Scratch folder;
  const std::string rig = other(other(cart, "gain: -400 N/m", "gain: = -k2"),
                                "blocks:", "parameters: {k: 60 N/m, k2: = 2*k, m: 2 kg}\nblocks:");
  folder.file("a.yaml", other(rig, "mass: 2 kg", "mass: $m"));
  folder.file("b.yaml", other(other(rig, "mass: 2 kg", "mass: $m"), "60 N/m", "75 N/m"));
  folder.file("c.yaml",
              other(other(rig, "mass: 2 kg", "mass: $m"), "k: 60 N/m, k2: = 2*k", "k: 75 N/m, k2: = 3*k"));
  const auto marks = [&](const char* file) {
    const Done done = run_program(folder, {"diff", "a.yaml", file, "-o", "x.svg"});
    REQUIRE(done.code == 1);
    const std::string picture = content_of(folder.path("x.svg"));
    std::size_t count = 0;
    for (std::size_t at = 0; (at = picture.find(">~<", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  folder.file("d.yaml", other(other(rig, "mass: 2 kg", "mass: $m"), "title: A cart", "title: A sled"));
  CHECK(marks("b.yaml") == marks("d.yaml") + 1);
  CHECK(marks("c.yaml") == marks("d.yaml") + 1);
}

TEST_CASE("diff --json has the differences, or the faults") {
  const Scratch folder;
  folder.file("a.yaml", cart);
  folder.file("b.yaml", other(cart, "2 Hz", "3 Hz"));
  const auto found = nlohmann::json::parse(run_program(folder, {"diff", "a.yaml", "b.yaml", "--json"}).out);
  CHECK(found["equal"] == false);
  const auto& change = found["files"][0]["changes"][0];
  CHECK(change["kind"] == "changed");
  CHECK(change["section"] == "values");
  CHECK(change["name"] == "push.frequency");
  CHECK(change["ratio"] == 1.5);
  CHECK(change["after_line"] == 7);
  const Done wrong = run_program(folder, {"diff", "a.yaml", "e.yaml", "--json"});
  CHECK(wrong.code == 2);
  CHECK(nlohmann::json::parse(wrong.out)["faults"].size() == 1);
}

TEST_CASE("diff compares the diagrams of two folders by their names") {
  const Scratch folder;
  std::filesystem::create_directories(folder.path("old/parts"));
  std::filesystem::create_directories(folder.path("new/parts"));
  folder.file("old/cart.yaml", cart);
  folder.file("new/cart.yaml", other(cart, "3 N", "4 N"));
  folder.file("old/parts/gone.yaml", cart);
  folder.file("new/notes.yaml", "a: 1\n");
  const Done done = run_program(folder, {"diff", "old", "new"});
  CHECK(done.code == 1);
  CHECK_THAT(done.out, Contains("push.amplitude: 3 N -> 4 N") && Contains("- body: {block: Mass") &&
                           !Contains("notes"));
}

TEST_CASE("diff takes a file from the revisions of git, with its parts") {
  const Repository repository;
  std::filesystem::create_directories(repository.folder.path("parts"));
  const std::string part =
      "stepwire: 1\ninputs: {x: {unit: m}}\noutputs: {f: s}\nblocks: {s: {block: Gain, u: x, gain: -1 "
      "N/m}}\n";
  repository.folder.file("parts/leaf.yaml", part);
  repository.write(other(cart, "{block: Gain, u: body.position, gain: -400 N/m}",
                         "{diagram: parts/leaf.yaml, x: body.position}"));
  repository.commit();
  repository.folder.file("parts/leaf.yaml", other(part, "-1 N/m", "-2 N/m"));
  const Scratch& folder = repository.folder;
  const Done now = run_program(folder, {"diff", "cart.yaml"});
  CHECK(now.code == 1);
  CHECK_THAT(now.out, Contains("HEAD:parts/leaf.yaml -> parts/leaf.yaml") &&
                          Contains("s.gain: -1 N/m -> -2 N/m (2 times)"));
  CHECK_THAT(run_program(folder, {"diff", "cart.yaml", "--rev", "HEAD~1..HEAD"}).out,
             Contains("spring: Gain -> parts/leaf.yaml"));
  const Done unknown = run_program(folder, {"diff", "cart.yaml", "--rev", "nothing"});
  CHECK(unknown.code == 2);
  CHECK_THAT(unknown.err, Contains("has no revision 'nothing'"));
}

TEST_CASE("git diff and git log -p show the meaning, and other YAML files by lines") {
  const Repository repository;
  repository.folder.file("notes.yaml", "a: [1\n");
  repository.commit();
  repository.write("# a comment\n" + other(cart, "2 Hz", "3 Hz"));
  repository.folder.file("notes.yaml", "a: [2\n");
  const std::string now = repository.git({"--no-pager", "diff"});
  CHECK(repository.code == 0);
  CHECK_THAT(now, Contains("~ push.frequency: 2 Hz -> 3 Hz (1.5 times)") && Contains("+a: [2") &&
                      !Contains("comment"));
  repository.commit();
  const std::string log = repository.git({"--no-pager", "log", "-p", "-1", "--", "cart.yaml"});
  CHECK_THAT(log, Contains("-blocks.push.frequency: 2 Hz") && Contains("+blocks.push.frequency: 3 Hz") &&
                      !Contains("comment"));
  repository.git({"mv", "cart.yaml", "wagon.yaml"});
  repository.git({"rm", "-q", "notes.yaml"});
  repository.git({"--no-pager", "diff", "HEAD"});
  CHECK(repository.code == 0);
}

TEST_CASE("git merge brings a rename and a use together, and leaves a conflict that check names") {
  const Repository repository;
  repository.git({"checkout", "-q", "-b", "side"});
  repository.write(other(cart, "body", "wagon"));
  repository.commit();
  repository.git({"checkout", "-q", "main"});
  repository.write(
      other(cart, "  sum: ", "  drag:   {block: Gain, u: body.velocity, gain: -1 N s/m}\n  sum: "));
  repository.commit();
  repository.git({"merge", "side", "-m", "both"});
  CHECK(repository.code == 0);
  const std::string merged = content_of(repository.folder.path("cart.yaml"));
  CHECK_THAT(merged, Contains("u: wagon.velocity") && !Contains("body"));
  CHECK(run_program(repository.folder, {"check", "cart.yaml"}).code == 0);

  repository.git({"checkout", "-q", "-b", "one"});
  repository.write(other(merged, "3 N", "4 N"));
  repository.commit();
  repository.git({"checkout", "-q", "main"});
  repository.write(other(merged, "3 N", "5 N"));
  repository.commit();
  repository.git({"merge", "one"});
  CHECK(repository.code == 1);
  const Done checked = run_program(repository.folder, {"check", "cart.yaml"});
  CHECK(checked.code == 2);
  CHECK_THAT(checked.err, Contains("push.amplitude: ours is 5 N, theirs is 4 N, before it was 3 N"));
}

TEST_CASE("merge writes another file with -o, and leaves ours alone if a file cannot be read") {
  const Scratch folder;
  folder.file("base.yaml", cart);
  folder.file("ours.yaml", other(cart, "3 N", "4 N"));
  folder.file("theirs.yaml", other(cart, "2 Hz", "3 Hz"));
  folder.file("broken.yaml", "stepwire: [");
  CHECK(run_program(folder, {"merge", "base.yaml", "ours.yaml", "theirs.yaml", "-o", "out.yaml"}).code == 0);
  CHECK(content_of(folder.path("out.yaml")) == other(other(cart, "3 N", "4 N"), "2 Hz", "3 Hz"));
  const Done broken = run_program(folder, {"merge", "base.yaml", "ours.yaml", "broken.yaml"});
  CHECK(broken.code == 2);
  CHECK(content_of(folder.path("ours.yaml")) == other(cart, "3 N", "4 N"));
  CHECK(run_program(folder, {"merge", "base.yaml", "ours.yaml", "nothing.yaml"}).code == 2);
  folder.file("third.yaml", other(cart, "3 N", "5 N"));
  const Done both = run_program(folder, {"merge", "base.yaml", "ours.yaml", "third.yaml", "-o", "m.yaml"});
  CHECK(both.code == 1);
  CHECK_THAT(both.err, Contains("m.yaml: push.amplitude: ours is 4 N, theirs is 5 N, before it was 3 N") &&
                           !Contains("ours.yaml"));
  folder.file("units.yaml", cart + "units: {push: N}\n");
  folder.file("kilos.yaml", other(cart, "3 N", "3 kg"));
  const Done faults = run_program(folder, {"merge", "base.yaml", "units.yaml", "kilos.yaml", "-o", "f.yaml"});
  CHECK(faults.code == 1);
  CHECK_THAT(faults.err, Contains("f.yaml:") && !Contains("units.yaml"));
}

TEST_CASE("git-setup prints its commands, and applies them once") {
  const Repository repository;
  const Done printed = run_program(repository.folder, {"git-setup"});
  CHECK_THAT(printed.out, Contains("git config merge.stepwire.driver") && Contains(">> .gitattributes"));
  REQUIRE(run_program(repository.folder, {"git-setup", "--apply"}).code == 0);
  CHECK(content_of(repository.folder.path(".gitattributes")) == "*.yaml diff=stepwire merge=stepwire\n");
  const Scratch outside;
  CHECK(run_program(outside, {"git-setup", "--apply"}).code == 2);
}

TEST_CASE("diff --results names the worst difference of each signal and the claims with another verdict") {
  // A lag of 0.1 s behind a step at 0: y = gain (1 - exp(-t / 0.1 s)). At 1 s the gains 2 and 3 differ most.
  const std::string lag =
      "stepwire: 1\ntitle: A lag\nstep: 10 ms\nstop: 1 s\nsolver: rk4\nblocks:\n"
      "  u: {block: Step, time: 0 s, after: 1 N}\n  y: {block: Lag, u: u, tau: 0.1 s, gain: 2}\n"
      "record: [u, y]\nclaims:\n  - {that: it is small, final: y in N, at_most: 2.5 N}\n"
      "  - {that: it is positive, final: y in N, at_least: 1 N}\n";
  const Scratch folder;
  folder.file("a.yaml", lag);
  folder.file("b.yaml", other(lag, "gain: 2", "gain: 3"));
  const auto found = run_program(folder, {"diff", "a.yaml", "b.yaml", "--results"});
  CHECK(found.code == 1);
  CHECK_THAT(found.out, Contains("~ y.gain: 2 -> 3"));
  CHECK_THAT(found.out, Contains("~ y: ") && Contains("at 1 s") && !Contains("~ u:"));
  CHECK_THAT(found.out, Contains("~ claim 'it is small': holds: 2 N -> does not hold: 3 N"));
  CHECK_THAT(found.out, !Contains("it is positive"));
  const auto json =
      nlohmann::json::parse(run_program(folder, {"diff", "a.yaml", "b.yaml", "--results", "--json"}).out);
  const auto& signals = json.at("results").at("signals").at("signals");
  CHECK(signals.at(0).at("name") == "y");
  CHECK(signals.at(0).at("difference").get<double>() == Approx(1.0 - std::exp(-10.0)).epsilon(1e-4));
  const auto same = run_program(folder, {"diff", "a.yaml", "a.yaml", "--results"});
  CHECK(same.code == 0);
  CHECK_THAT(same.out, Contains("all recorded signals and all verdicts are the same"));
}

TEST_CASE("diff names a part that cannot be read in one of the versions, at any depth, and ends with 2") {
  const Scratch folder;
  const std::string user = "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n  p: {diagram: parts/FILE}\n";
  for (const std::string side : {"old", "new"}) {
    std::filesystem::create_directories(folder.path(side + "/parts"));
    folder.file(side + "/main.yaml", other(user, "FILE", "mid.yaml"));
    folder.file(side + "/parts/mid.yaml", other(user, "parts/FILE", "inner.yaml"));
    folder.file(side + "/parts/inner.yaml", cart);
  }
  CHECK(run_program(folder, {"diff", "old/main.yaml", "new/main.yaml"}).code == 0);
  std::filesystem::remove(folder.path("new/parts/inner.yaml"));
  const Done gone = run_program(folder, {"diff", "old/main.yaml", "new/main.yaml"});
  CHECK(gone.code == 2);
  CHECK(gone.out.empty());
  CHECK_THAT(gone.err, Contains("new/parts/inner.yaml: no such file (used by new/parts/mid.yaml:5:3)"));
  folder.file("old/parts/mid.yaml", "stepwire: [");
  const Done json = run_program(folder, {"diff", "old/main.yaml", "new/main.yaml", "--json"});
  CHECK(json.code == 2);
  CHECK_THAT(json.out, Contains("\"file\": \"old/parts/mid.yaml\""));
}

TEST_CASE("a fault of a version that is merged has the name of its file") {
  const Scratch folder;
  folder.file("good.yaml", cart);
  folder.file("bad.yaml", other(cart, "2 Hz", "[2 Hz"));
  for (const std::vector<std::string> files : {std::vector<std::string>{"bad.yaml", "good.yaml", "good.yaml"},
                                               {"good.yaml", "bad.yaml", "good.yaml"},
                                               {"good.yaml", "good.yaml", "bad.yaml"}}) {
    const Done done = run_program(folder, {"merge", files[0], files[1], files[2], "-o", "out.yaml"});
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Catch::StartsWith("bad.yaml:7:"));
  }
}

TEST_CASE("diff --results prints the differences first where a version cannot run") {
  const Scratch folder;
  const std::string text =
      "stepwire: 1\nstep: 1 ms\nstop: 10 ms\nblocks:\n  a: {block: Clock}\n"
      "  b: {block: Gain, u: a, gain: 2}\nrecord: b\n";
  folder.file("a.yaml", text);
  folder.file("b.yaml", text + "  - c\n");
  folder.file("b.yaml", std::string(text).replace(text.find("gain: 2"), 7, "gain: 3, u2: a"));
  const Done done = run_program(folder, {"diff", "a.yaml", "b.yaml", "--results"});
  CHECK(done.code == 2);
  CHECK_THAT(done.out, Catch::Contains("~ b.gain: 2 -> 3 (1.5 times)"));
  CHECK_THAT(done.err, Catch::Contains("b.yaml:6:") && Catch::Contains("has no 'u2'"));
  const Done json = run_program(folder, {"diff", "a.yaml", "b.yaml", "--results", "--json"});
  CHECK(json.code == 2);
  CHECK(nlohmann::json::parse(json.out).at("files").size() == 1);
  CHECK(nlohmann::json::parse(json.out).at("faults").size() == 1);
}
