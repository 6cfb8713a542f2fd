// Parts by version: the section `uses` and the verb fetch, with repositories that the tests make.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/base/subprocess/process.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

namespace fs = std::filesystem;

const std::string doubler = R"yaml(stepwire: 1
title: Twice its input
parameters:
  factor: {value: 2, doc: of the input}
inputs: {x: {}}
outputs: {y: gain}
blocks:
  gain: {block: Gain, u: x, gain: $factor}
)yaml";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// A folder with a repository `lib` of parts, a cache of its own, and diagrams that use the repository.
class Workshop {
 public:
  Workshop() {
    fs::create_directory(folder.path("lib"));
    fs::create_directory(folder.path("cache"));
    git("lib", {"init", "-q", "-b", "main"});
    folder.file("lib/doubler.yaml", doubler);
    first = commit("lib");
  }

  std::string git(const std::string& repository, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(),
                     {"git", "-C", folder.path(repository), "-c", "user.email=a@b.c", "-c", "user.name=A"});
    const auto result = stepwire::subprocess::run_process({.command = arguments});
    INFO(result.errors);
    REQUIRE(result.succeeded());
    return result.output.substr(0, result.output.find('\n'));
  }
  std::string commit(const std::string& repository) const {
    git(repository, {"add", "-A"});
    git(repository, {"commit", "-q", "--allow-empty", "-m", "change"});
    return git(repository, {"rev-parse", "HEAD"});
  }
  Done run(std::vector<std::string> arguments) const {
    return run_program(folder, Call{std::move(arguments), {{"STEPWIRE_CACHE", folder.path("cache")}}});
  }
  /// Writes a diagram that uses a commit, with further keys of its entry.
  void use(const std::string& rev, const std::string& keys, const std::string& git = "lib") const {
    folder.file("main.yaml",
                "stepwire: 1\ntitle: A part of a repository\nstep: 1 s\nstop: 1 s\n"
                "uses:\n  rig: {git: \"" +
                    git + "\", rev: " + rev + keys +
                    "}\n"
                    "blocks:\n  one: {block: Constant, value: 3}\n"
                    "  two: {diagram: rig/doubler, x: one}\n"
                    "record: [two.y]\nclaims:\n  - {that: it doubles, final: two.y, equals: 6}\n");
  }
  /// Returns the sha256 that fetch prints for the diagram.
  std::string printed_hash() const {
    const Done refused = run({"fetch", "main.yaml"});
    CHECK(refused.code == 2);
    const std::size_t at = refused.err.find("write sha256: ");
    INFO(refused.err);
    REQUIRE(at != std::string::npos);
    return refused.err.substr(at + 14, 64);
  }
  /// Writes a diagram that uses a commit of the repository, and fetches it.
  std::string fetched(const std::string& rev) const {
    use(rev, "");
    const std::string hash = printed_hash();
    use(rev, ", sha256: " + hash);
    return hash;
  }

  Scratch folder;
  std::string first;
};

}  // namespace

// python3 -c "import hashlib, sys; h = lambda b: hashlib.sha256(b).hexdigest(); c = sys.stdin.buffer.read()
// print(h(b'doubler.yaml\0' + h(c).encode() + b'\n'))" < doubler.yaml
TEST_CASE("fetch prints the missing sha256 of a repository, and a run uses the fetched part") {
  const Workshop shop;
  shop.use(shop.first, "");
  const Done missing = shop.run({"run", "main.yaml"});
  CHECK(missing.code == 2);
  CHECK_THAT(missing.err, Contains("main.yaml:6:8: uses.rig: 'sha256' is missing"));
  const std::string hash = shop.printed_hash();
  CHECK(hash == "3257828ff161a3d0d5254224e723f1573ba8a8fd135e367223a42c0fc512be2e");
  shop.use(shop.first, ", sha256: " + hash);
  const Done fetched = shop.run({"fetch", "main.yaml"});
  CHECK(fetched.code == 0);
  CHECK(fetched.out == "rig: 1 file of " + shop.first + " from lib, there already\n");
  CHECK(shop.run({"run", "main.yaml", "--out", "out"}).code == 0);
  const auto note = nlohmann::json::parse(content_of(shop.folder.path("out/run.json")));
  CHECK(note["uses"] == nlohmann::json::parse(R"([{"name": "rig", "git": "lib", "rev": ")" + shop.first +
                                              R"(", "sha256": ")" + hash + R"("}])"));
  CHECK(shop.run({"verify", "out"}).code == 0);
}

TEST_CASE("only fetch connects to a repository, and other verbs name the call that does") {
  const Workshop shop;
  const std::string hash = shop.fetched(shop.first);
  fs::remove_all(shop.folder.path("cache"));
  for (const char* verb : {"run", "check", "draw", "flatten"}) {
    const Done done = shop.run({verb, "main.yaml"});
    CHECK(done.code == 2);
    CHECK(done.err == "main.yaml:6:3: uses.rig: rig at " + shop.first +
                          " is not fetched; `stepwire fetch main.yaml` fetches it\n");
  }
  const Done in_hook = run_program(shop.folder, Call{{"fetch", "main.yaml"},
                                                     {{"STEPWIRE_CACHE", shop.folder.path("other")},
                                                      {"GIT_DIR", shop.folder.path("nowhere")}}});
  CHECK(in_hook.code == 0);  // as called from a hook of git
  CHECK_FALSE(fs::exists(shop.folder.path("nowhere")));
  CHECK(shop.run({"fetch"}).out == "rig: 1 file of " + shop.first + " from lib\n");
  CHECK(shop.run({"check", "main.yaml"}).code == 0);
}

TEST_CASE("fetched files that were changed are refused, and fetched again") {
  const Workshop shop;
  const std::string hash = shop.fetched(shop.first);
  const std::string file = "cache/parts/" + shop.first + "-" + hash + "/doubler.yaml";
  REQUIRE(content_of(shop.folder.path(file)) == doubler);
  fs::permissions(shop.folder.path(file), fs::perms::owner_all);
  shop.folder.file(file, replaced(doubler, "value: 2", "value: 3"));
  const Done refused = shop.run({"run", "main.yaml"});
  CHECK(refused.code == 2);
  CHECK_THAT(refused.err, Contains("the fetched files of rig at " + shop.first + " were changed"));
  CHECK(shop.run({"fetch", "main.yaml"}).code == 0);
  CHECK(shop.run({"run", "main.yaml"}).code == 0);
}

TEST_CASE("a tag, a branch and a short commit are refused with the commit of the name") {
  const Workshop shop;
  shop.git("lib", {"tag", "-a", "v1", "-m", "one"});
  for (const std::string name : {"v1", "main"}) {
    shop.use(name, ", sha256: " + std::string(64, '0'));
    CHECK_THAT(shop.run({"check", "main.yaml"}).err, Contains("'" + name + "' is no commit of 40 digits"));
    const Done refused = shop.run({"fetch", "main.yaml"});
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Contains("at present it is rev: " + shop.first));
  }
  shop.use("\"" + shop.first.substr(0, 8) + "\"", "");
  CHECK_THAT(shop.run({"fetch", "main.yaml"}).err, Contains("is no commit of 40 digits"));
  shop.use(shop.git("lib", {"rev-parse", "v1"}), "");
  CHECK_THAT(shop.run({"fetch", "main.yaml"}).err, Contains("is no commit; write rev: " + shop.first));
  shop.use(std::string(40, 'a'), "");
  CHECK_THAT(shop.run({"fetch", "main.yaml"}).err, Contains("has no commit " + std::string(40, 'a')));
}

TEST_CASE("another sha256 or commit than that of the files is refused with the right one") {
  const Workshop shop;
  const std::string hash = shop.fetched(shop.first);
  shop.use(shop.first, ", sha256: " + std::string(64, '1'));
  CHECK(shop.run({"run", "main.yaml"}).code == 2);
  const Done refused = shop.run({"fetch", "main.yaml"});
  CHECK(refused.code == 2);
  CHECK_THAT(refused.err, Contains("theirs is sha256: " + hash));
  shop.folder.file("lib/doubler.yaml", replaced(doubler, "value: 2", "value: 5"));
  shop.use(shop.commit("lib"), ", sha256: " + hash);
  CHECK_THAT(shop.run({"run", "main.yaml"}).err, Contains("is not fetched"));
  CHECK_THAT(shop.run({"fetch", "main.yaml"}).err, Contains("do not have the sha256"));
}

TEST_CASE("addresses by which git would run a program, and other schemes, are refused") {
  const Workshop shop;
  const std::string hash = shop.fetched(shop.first);
  for (const std::string git :
       {"ext::sh -c touch% pwned", "--upload-pack=touch pwned", "http://example.org/rig.git",
        "git://example.org/rig.git", "ssh://-oProxyCommand=touch/x", "https://me:secret@example.org/rig.git",
        "-u@host:x", "fd::3", "file://host/x", ""}) {
    INFO(git);
    shop.use(shop.first, ", sha256: " + hash, git);
    CHECK(shop.run({"check", "main.yaml"}).code == 2);
    const Done refused = shop.run({"fetch", "main.yaml"});
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Contains("main.yaml:6:3: uses.rig: "));
  }
  CHECK_FALSE(fs::exists(shop.folder.path("pwned")));
  shop.use("\"--upload-pack=touch pwned\"", "");
  CHECK(shop.run({"fetch", "main.yaml"}).code == 2);
  CHECK_FALSE(fs::exists(shop.folder.path("pwned")));
  shop.use(shop.first, ", sha256: " + hash, "file://" + shop.folder.path("lib"));
  CHECK(shop.run({"fetch", "main.yaml"}).code == 0);
}

TEST_CASE("a path may have an @, and text that git takes for an address is refused where it is a path") {
  const Workshop shop;
  const std::string hash = shop.fetched(shop.first);
  for (const char* name : {"my@repo", "me@host"})
    fs::copy(shop.folder.path("lib"), shop.folder.path(name), fs::copy_options::recursive);
  fs::create_directory(shop.folder.path("below"));
  for (const char* address : {"./my@repo", "my@repo", "below/../me@host"}) {
    fs::remove_all(shop.folder.path("cache/parts"));
    shop.use(shop.first, ", sha256: " + hash, address);
    const Done done = shop.run({"fetch", "main.yaml"});
    INFO(address << "\n" << done.out << done.err);
    CHECK(done.code == 0);
    CHECK(shop.run({"run", "main.yaml"}).code == 0);
  }
  fs::copy(shop.folder.path("lib"), shop.folder.path("me@host:lib"), fs::copy_options::recursive);
  shop.use(shop.first, ", sha256: " + hash, "me@host:lib");
  CHECK_THAT(
      shop.run({"fetch", "main.yaml"}).err,
      Contains("'me@host:lib' is a path here, and git takes it for an address; write ./me@host:lib for "
               "the path, or ssh://user@host/path"));
  shop.use(shop.first, ", sha256: " + hash, "./me@host:lib");
  CHECK(shop.run({"fetch", "main.yaml"}).code == 0);
  shop.use(shop.first, ", sha256: " + hash, "host:lib");
  CHECK_THAT(shop.run({"check", "main.yaml"}).err,
             Contains("'host:lib' has no user; write ./host:lib for the path, or user@host:path"));
}

TEST_CASE("a link that leads out of a repository is refused, one inside is kept") {
  const Workshop shop;
  fs::create_symlink("doubler.yaml", shop.folder.path("lib/same.yaml"));
  const std::string inside = shop.commit("lib");
  shop.fetched(inside);
  const std::string main = content_of(shop.folder.path("main.yaml"));
  shop.folder.file("main.yaml", replaced(main, "rig/doubler", "rig/same.yaml"));
  CHECK(shop.run({"run", "main.yaml"}).code == 0);
  for (const char* target : {"../main.yaml", "/etc/hostname", "sub/../../main.yaml"}) {
    fs::remove(shop.folder.path("lib/out.yaml"));
    fs::create_symlink(target, shop.folder.path("lib/out.yaml"));
    shop.use(shop.commit("lib"), "");
    const Done refused = shop.run({"fetch", "main.yaml"});
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Contains("the link 'out.yaml' leads out of the repository"));
  }
}

// git makes no tree with a path twice, yet fetches one. A file below a link would be written where the link
// leads.
TEST_CASE("a commit with a link and a folder of one name is refused before a file is written") {
  const Workshop shop;
  const auto bytes = [](const std::string& hex) {
    std::string all;
    for (std::size_t i = 0; i < hex.size(); i += 2)
      all += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
    return all;
  };
  shop.folder.file("lib/target", shop.folder.path("outside"));
  fs::create_directory(shop.folder.path("outside"));
  const std::string target = shop.git("lib", {"hash-object", "-w", "target"});
  const std::string inner = shop.git("lib", {"rev-parse", shop.first + "^{tree}"});
  shop.folder.file("lib/tree", "120000 a" + std::string(1, '\0') + bytes(target) + "40000 a" +
                                   std::string(1, '\0') + bytes(inner));
  const std::string tree = shop.git("lib", {"hash-object", "-t", "tree", "-w", "--literally", "tree"});
  const std::string commit = shop.git("lib", {"commit-tree", "-m", "two", tree});
  shop.git("lib", {"update-ref", "refs/heads/main", commit});
  shop.use(commit, "");
  const Done refused = shop.run({"fetch", "main.yaml"});
  CHECK(refused.code == 2);
  CHECK_THAT(refused.err, Contains("'a'") && Contains("refused"));
  CHECK(fs::is_empty(shop.folder.path("outside")));
}

TEST_CASE("a path that leads out of the fetched files is refused") {
  const Workshop shop;
  shop.folder.file("lib/outside.yaml", replaced(doubler, "{block: Gain, u: x, gain: $factor}",
                                                "{diagram: ../../../main.yaml, u: x, gain: $factor}"));
  shop.fetched(shop.commit("lib"));
  const std::string main = content_of(shop.folder.path("main.yaml"));
  shop.folder.file("main.yaml", replaced(main, "rig/doubler", "rig/outside"));
  CHECK_THAT(shop.run({"check", "main.yaml"}).err, Contains("is outside of the fetched files"));
  shop.folder.file("main.yaml", replaced(main, "rig/doubler", "rig/../../x"));
  CHECK_THAT(shop.run({"check", "main.yaml"}).err, Contains("is outside of the fetched files"));
  shop.folder.file("main.yaml", replaced(main, "rig/doubler", "rig/doublr"));
  CHECK_THAT(shop.run({"check", "main.yaml"}).err, Contains("did you mean 'rig/doubler'?"));
}

TEST_CASE("the parts of a fetched part are fetched, and two versions of one name are refused") {
  const Workshop shop;
  const std::string hash = shop.fetched(shop.first);
  fs::create_directory(shop.folder.path("top"));
  shop.git("top", {"init", "-q", "-b", "main"});
  const auto quadruple = [&](const std::string& rev, const std::string& sha256) {
    shop.folder.file("top/quadruple.yaml",
                     "stepwire: 1\nuses:\n  rig: {git: \"" + shop.folder.path("lib") + "\", rev: " + rev +
                         ", sha256: " + sha256 +
                         "}\ninputs: {x: {}}\noutputs: {y: b}\nblocks:\n"
                         "  a: {diagram: rig/doubler, x: x}\n  b: {diagram: rig/doubler, x: a}\n");
    return shop.commit("top");
  };
  const auto use = [&](const std::string& rev, const std::string& more) {
    shop.folder.file("main.yaml",
                     "stepwire: 1\nstep: 1 s\nstop: 1 s\nuses:\n  outer: {git: top, rev: " + rev + more +
                         "blocks:\n  one: {block: Constant, value: 3}\n"
                         "  four: {diagram: outer/quadruple, x: one}\nrecord: [four.y]\n"
                         "claims:\n  - {that: four times, final: four.y, equals: 12}\n");
  };
  const std::string top = quadruple(shop.first, hash);
  use(top, "}\n");
  const std::string hash_of_top = shop.printed_hash();
  fs::remove_all(shop.folder.path("cache"));
  use(top, ", sha256: " + hash_of_top + "}\n");
  const Done both = shop.run({"fetch", "main.yaml"});
  CHECK(both.code == 0);
  CHECK_THAT(both.out, Contains("outer: 1 file of " + top) && Contains("rig: 1 file of " + shop.first));
  CHECK(shop.run({"run", "main.yaml"}).code == 0);

  shop.folder.file("lib/doubler.yaml", replaced(doubler, "value: 2", "value: 5"));
  const std::string second = shop.commit("lib");
  shop.use(second, "");
  const std::string hash_of_second = shop.printed_hash();
  use(top, ", sha256: " + hash_of_top + "}\n  rig: {git: lib, rev: " + second +
               ", sha256: " + hash_of_second + "}\n");
  const std::string main = content_of(shop.folder.path("main.yaml"));
  shop.folder.file("main.yaml", replaced(main, "record:", "  five: {diagram: rig/doubler, x: one}\nrecord:"));
  for (const char* verb : {"fetch", "check"}) {
    const Done refused = shop.run({verb, "main.yaml"});
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Contains("rig is at " + shop.first + " here and at " + second +
                                     " in main.yaml:6:3; use one version in all files") &&
                                Contains("quadruple.yaml:3:3: "));
  }
}

TEST_CASE("a name of uses is no folder here, has a part, and differs from stepwire") {
  const Workshop shop;
  const std::string hash = shop.fetched(shop.first);
  fs::create_directory(shop.folder.path("rig"));
  CHECK_THAT(shop.run({"check", "main.yaml"}).err, Contains("is also the name of a file or folder here"));
  fs::remove(shop.folder.path("rig"));
  const std::string main = content_of(shop.folder.path("main.yaml"));
  shop.folder.file("main.yaml", replaced(main, "diagram: rig/doubler", "block: Gain, gain: 2"));
  CHECK_THAT(shop.run({"check", "main.yaml"}).err, Contains("no part of this file begins with 'rig/'"));
  shop.folder.file("main.yaml", replaced(replaced(main, "rig/", "stepwire/"), "  rig:", "  stepwire:"));
  CHECK_THAT(shop.run({"check", "main.yaml"}).err, Contains("is the name of the parts of this program"));
}

TEST_CASE("submodules and the content of Git LFS are left out with a sentence") {
  const Workshop shop;
  shop.git("lib", {"update-index", "--add", "--cacheinfo", "160000," + shop.first + ",inner"});
  shop.folder.file("lib/big.csv", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n");
  shop.git("lib", {"add", "big.csv"});
  shop.git("lib", {"commit", "-q", "-m", "submodule"});
  shop.fetched(shop.git("lib", {"rev-parse", "HEAD"}));
  fs::remove_all(shop.folder.path("cache"));
  const Done fetched = shop.run({"fetch", "main.yaml"});
  CHECK(fetched.code == 0);
  CHECK_THAT(fetched.out, Contains("rig: 2 files of "));
  CHECK_THAT(fetched.err, Contains("inner is a submodule, which is not fetched") &&
                              Contains("big.csv is a pointer of Git LFS, whose content is not fetched"));
}

TEST_CASE("diff compares the parts of two commits") {
  const Workshop shop;
  shop.fetched(shop.first);
  fs::copy(shop.folder.path("main.yaml"), shop.folder.path("old.yaml"));
  shop.folder.file("lib/doubler.yaml", replaced(doubler, "value: 2", "value: 5"));
  const std::string second = shop.commit("lib");
  shop.fetched(second);
  const Done changed = shop.run({"diff", "old.yaml", "main.yaml"});
  CHECK(changed.code == 1);
  CHECK_THAT(changed.out, Contains(shop.first + " -> " + second) && Contains("factor: 2 -> 5 (2.5 times)"));
  CHECK_THAT(changed.out, Contains("\nrig/doubler.yaml at " + shop.first.substr(0, 7) +
                                   " -> rig/doubler.yaml at " + second.substr(0, 7) + "\n"));
  fs::remove_all(shop.folder.path("cache"));
  REQUIRE(shop.run({"fetch", "main.yaml"}).code == 0);
  const Done unknown = shop.run({"diff", "old.yaml", "main.yaml"});
  CHECK(unknown.code == 1);
  CHECK_THAT(unknown.out, Contains("~ two: rig/doubler at " + shop.first + " -> rig/doubler at " + second +
                                   ", as one of them is not fetched"));
}

TEST_CASE("diagrams that have nothing in common may use two versions of one repository") {
  const Workshop shop;
  const std::string old_hash = shop.fetched(shop.first);
  fs::rename(shop.folder.path("main.yaml"), shop.folder.path("old.yaml"));
  shop.folder.file("lib/doubler.yaml", replaced(doubler, "value: 2", "value: 3"));
  shop.fetched(shop.commit("lib"));
  CHECK(shop.run({"fetch", "old.yaml", "main.yaml"}).code == 0);
  CHECK(shop.run({"fetch"}).code == 0);
  const Done done = shop.run({"run", "old.yaml", "main.yaml"});
  INFO(done.out << done.err);
  CHECK_THAT(done.out, Contains("it doubles: 6") && Contains("it doubles: 9"));
}
