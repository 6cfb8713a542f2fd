#include "engine/app/studio/edited_texts.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/app/studio/fault.hpp"
#include "tests/engine/app/cli/program.hpp"

namespace stepwire::studio {

namespace {

namespace fs = std::filesystem;

/// A file, and a place for drafts of its own.
struct Opened {
  explicit Opened(const std::string& text = "one\n") : path(scratch.file("a.yaml", text)) {
    beneath.add(fs::path(path).parent_path().string());
  }
  /// As after another start.
  EditedTexts texts() const { return {beneath, DraftStore(scratch.path("state/studio"))}; }
  void change_elsewhere(const std::string& text) const {
    scratch.file("a.yaml", text);
    fs::last_write_time(path,
                        fs::last_write_time(path) + std::chrono::seconds(1));  // clocks of files are coarse
  }

  Scratch scratch;
  Beneath beneath;
  std::string path;
};

mode_t mode_of(const fs::path& path) {
  struct stat status {};
  ::stat(path.c_str(), &status);
  return status.st_mode & 0777u;
}

}  // namespace

TEST_CASE("an edit changes the version that it was made of, and no other") {
  const Opened opened;
  EditedTexts texts = opened.texts();
  CHECK(texts.open(opened.path).version == 0);
  CHECK(texts.edit(opened.path, 0, {{0, 3, "two"}}).text == "two\n");
  CHECK(texts.open(opened.path).version == 1);
  CHECK(texts.open(opened.path).saved == "one\n");
  try {
    texts.edit(opened.path, 0, {{0, 3, "three"}});
    FAIL("an old version was edited");
  } catch (const Fault& fault) {
    const json::Json& current = *fault.more().find("current");
    CHECK(*current.find("text")->as_text() == "two\n");
    CHECK(current.find("version")->as_number() == 1);
  }
  CHECK_THROWS_AS(texts.edit(opened.path, 1, {{7, 9, ""}}), Fault);
  CHECK(texts.open(opened.path).version == 1);
}

TEST_CASE("saving writes the file where its hash is still that one") {
  const Opened opened;
  EditedTexts texts = opened.texts();
  const std::string hash = texts.open(opened.path).hash;
  texts.edit(opened.path, 0, {{0, 3, "two"}});
  CHECK_FALSE(texts.save(opened.path, hash));
  CHECK(content_of(opened.path) == "two\n");
  CHECK_FALSE(texts.open(opened.path).is_draft());
  CHECK(texts.open(opened.path).hash != hash);
}

TEST_CASE("a file that changed elsewhere is not written; both texts are there") {
  const Opened opened;
  EditedTexts texts = opened.texts();
  const std::string hash = texts.open(opened.path).hash;
  texts.edit(opened.path, 0, {{0, 3, "mine"}});
  opened.change_elsewhere("theirs\n");
  const auto other = texts.save(opened.path, hash);
  REQUIRE(other);
  CHECK(other->now.saved == "theirs\n");
  CHECK(content_of(opened.path) == "theirs\n");
  CHECK(texts.open(opened.path).text == "mine\n");
  CHECK_FALSE(texts.save(opened.path, other->now.hash));
  CHECK(content_of(opened.path) == "mine\n");
}

TEST_CASE("a draft is there after another start, for its user alone, and goes with saving or discarding") {
  const Opened opened;
  {
    EditedTexts texts = opened.texts();
    texts.edit(opened.path, 0, {{0, 3, "draft"}});
    texts.keep_drafts();
  }
  const fs::path state = opened.scratch.path("state/studio");
  CHECK(mode_of(state) == 0700);
  for (const auto& entry : fs::directory_iterator(state)) CHECK(mode_of(entry.path()) == 0600);
  CHECK(opened.texts().open(opened.path).text == "draft\n");
  EditedTexts texts = opened.texts();
  CHECK(texts.open(opened.path).saved == "one\n");
  CHECK(texts.discard(opened.path).text == "one\n");
  CHECK_FALSE(opened.texts().open(opened.path).is_draft());
  texts.edit(opened.path, texts.open(opened.path).version, {{0, 3, "two"}});
  texts.keep_drafts();
  texts.save(opened.path, texts.open(opened.path).hash);
  CHECK_FALSE(opened.texts().open(opened.path).is_draft());
  CHECK(fs::is_empty(state));
}

TEST_CASE("a draft of a file that changed while nobody looked is not saved over it") {
  const Opened opened;
  {
    EditedTexts texts = opened.texts();
    texts.edit(opened.path, 0, {{0, 3, "draft"}});
    texts.keep_drafts();
  }
  opened.change_elsewhere("theirs\n");
  EditedTexts texts = opened.texts();
  const EditedText& text = texts.open(opened.path);
  CHECK(text.text == "draft\n");
  CHECK(text.saved == "theirs\n");
  CHECK(texts.save(opened.path, text.hash));
  CHECK(content_of(opened.path) == "theirs\n");
}

TEST_CASE("an edit that is taken back leaves no draft") {
  const Opened opened;
  EditedTexts texts = opened.texts();
  texts.edit(opened.path, 0, {{0, 3, "two"}});
  texts.keep_drafts();
  texts.edit(opened.path, 1, {{0, 3, "one"}});
  texts.keep_drafts();
  CHECK(fs::is_empty(opened.scratch.path("state/studio")));
}

TEST_CASE("lines that another program wrote come into a draft that has changed others, or stay apart") {
  const Opened opened;
  EditedTexts texts = opened.texts();
  opened.change_elsewhere("a\nb\nc\nd\n");
  std::vector<WrittenElsewhere> seen;
  const auto look = [&] {
    texts.look_for_changes(
        [&](const std::string&, const WrittenElsewhere& written) { seen.push_back(written); });
  };
  texts.edit(opened.path, texts.open(opened.path).version, {{0, 1, "A"}});
  opened.change_elsewhere("a\nb\nc\nD\n");
  look();
  REQUIRE(seen.size() == 1);
  CHECK(seen[0].is_merged);
  CHECK(seen[0].changes == std::vector<TextChange>{{6, 8, "D\n"}});
  CHECK(texts.open(opened.path).text == "A\nb\nc\nD\n");
  CHECK(seen[0].now.version == texts.open(opened.path).version);
  opened.change_elsewhere("x\nb\nC\nD\n");
  look();
  REQUIRE(seen.size() == 2);
  CHECK_FALSE(seen[1].is_merged);
  CHECK(seen[1].both == "A\n# in the file: x\nb\nC\nD\n");
  CHECK(texts.open(opened.path).text == "A\nb\nc\nD\n");
  const auto refused = texts.save(opened.path, texts.open(opened.path).hash);
  REQUIRE(refused);
  CHECK(refused->both == seen[1].both);
  CHECK(content_of(opened.path) == "x\nb\nC\nD\n");
  CHECK_FALSE(texts.save(opened.path, refused->now.hash));
  CHECK(content_of(opened.path) == "A\nb\nc\nD\n");
}

TEST_CASE("what others write on the disk is seen, a text without draft follows, a draft stays") {
  const Opened opened;
  EditedTexts texts = opened.texts();
  texts.open(opened.path);
  std::vector<std::string> seen;
  const auto look = [&] {
    texts.look_for_changes(
        [&](const std::string&, const WrittenElsewhere& written) { seen.push_back(written.now.saved); });
  };
  look();
  CHECK(seen.empty());
  opened.change_elsewhere("theirs\n");
  look();
  look();
  CHECK(seen == std::vector<std::string>{"theirs\n"});
  CHECK(texts.open(opened.path).text == "theirs\n");
  CHECK(texts.open(opened.path).version == 1);
  texts.edit(opened.path, 1, {{0, 0, "my "}});
  fs::remove(opened.path);
  look();
  opened.change_elsewhere("again\n");
  look();
  CHECK(seen.back() == "again\n");
  CHECK(texts.open(opened.path).text == "my theirs\n");
}

TEST_CASE("ends of lines stay what they are on the disk") {
  const Opened opened("one\r\ntwo\r\n");
  EditedTexts texts = opened.texts();
  CHECK(texts.open(opened.path).text == "one\ntwo\n");
  texts.edit(opened.path, 0, {{4, 7, "2"}});
  CHECK_FALSE(texts.save(opened.path, texts.open(opened.path).hash));
  CHECK(content_of(opened.path) == "one\r\n2\r\n");
}

TEST_CASE("what is no text cannot be edited") {
  const Opened opened("\xff\xfe");
  CHECK_THROWS_WITH(opened.texts().open(opened.path), Catch::Contains("is no text in UTF-8"));
}

TEST_CASE("lines that were not edited keep their ends in a file of mixed ones, and new ones get the usual") {
  const Opened opened("a\r\nb\nc\nd\r\ne\n");
  EditedTexts texts = opened.texts();
  REQUIRE(texts.open(opened.path).saved == "a\nb\nc\nd\ne\n");
  texts.edit(opened.path, 0, {{2, 3, "B\nnew"}, {10, 10, "f\n"}});
  CHECK_FALSE(texts.save(opened.path, texts.find(opened.path)->hash));
  CHECK(content_of(opened.path) == "a\r\nB\nnew\nc\nd\r\ne\nf\n");
  texts.edit(opened.path, 1, {{0, 16, "a\nc\nx\nd\ne\nf\n"}});  // the whole text at once
  CHECK_FALSE(texts.save(opened.path, texts.find(opened.path)->hash));
  CHECK(content_of(opened.path) == "a\r\nc\nx\nd\r\ne\nf\n");
}

TEST_CASE("a line without an end at the end of a file gets the usual one when another follows") {
  CHECK(with_line_ends_of("a\r\nb", "a\nb\nc") == "a\r\nb\r\nc");
  CHECK(with_line_ends_of("a\nb", "a\nb\nc") == "a\nb\nc");
  CHECK(with_line_ends_of("", "a\n") == "a\n");
}

}  // namespace stepwire::studio
