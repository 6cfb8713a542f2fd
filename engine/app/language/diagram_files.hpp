#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/language/open_texts.hpp"
#include "engine/app/language/written_names.hpp"

namespace stepwire::language {

/// What a name means: something that a file defines.
struct Meaning {
  enum class Kind { block, parameter, input, output, port };
  std::string file;
  Kind kind = Kind::block;
  std::string name;  ///< as that file calls it; of a port with its block: lag.y

  bool operator==(const Meaning&) const = default;
};

/// A piece of a written name that is a name for itself: "rig" and "x" of "rig.x".
struct NamePiece {
  TextRange range;
  Meaning meaning;
};

/// A place in a file.
struct FilePlace {
  std::string file;
  TextRange range;

  auto operator<=>(const FilePlace&) const = default;
};

/// The diagram files around those that are open, and what their names mean.
class DiagramFiles {
 public:
  explicit DiagramFiles(const Registry& registry, FileAccess access = {})
      : registry_(registry), texts_(std::move(access)), forms_(registry) {}

  OpenTexts& texts() { return texts_; }
  const Registry& registry() const { return registry_; }
  /// Forms of the places of a file, until another one is asked for.
  Forms& forms(const std::string& file);
  /// Folders below which files may use those that are open.
  void set_folders(std::vector<std::string> folders) { folders_ = std::move(folders); }

  /// The last tree of a file that could be read, or null.
  std::shared_ptr<const yaml::Document> tree(const std::string& file) { return texts_.last_document(file); }
  /// All names of a file as it is now; none where it is no YAML.
  const std::vector<WrittenName>& names(const std::string& file);
  /// The name that stands at a place, or nullptr.
  const WrittenName* name_at(const std::string& file, std::size_t offset);

  /// The pieces of a name from the left, as far as they mean something.
  std::vector<NamePiece> pieces(const std::string& file, const WrittenName& name);
  std::optional<NamePiece> piece_at(const std::string& file, std::size_t offset);
  /// Where it is defined: its key.
  std::optional<FilePlace> definition(const Meaning& meaning);
  /// All places that name it, its definition with them, in all files that are known.
  std::vector<FilePlace> references(const Meaning& meaning);
  /// Files that are open or lie below the folders.
  std::vector<std::string> paths();

  /// What stands under a name in a section of a file: the entry of a block, a parameter, a port; or nullptr.
  static const yaml::Entry* entry(const yaml::Document& document, const char* section,
                                  const std::string& name);
  /// The file of a part that stands under a name of another file; empty where that is none.
  static std::string part_file(const std::string& user, const yaml::Entry& block);
  /// The block with whose name a reference begins, or nullptr; names of blocks may have dots themselves.
  static const yaml::Entry* block_at_start(const yaml::Document& document, std::string_view reference);
  /// The outputs of a block or part; none where its kind is not known.
  std::vector<std::string> outputs(const std::string& file, const yaml::Entry& block);
  /// Does the name of a block or part stand for its first output?
  bool has_one_output(const std::string& file, const yaml::Entry& block);

 private:
  struct NamesOf {
    std::shared_ptr<const yaml::Document> document;
    std::vector<WrittenName> names;
  };
  /// Of a key that defines something, or that belongs to a block.
  std::optional<Meaning> meaning_of_key(const std::string& file, const WrittenName& name);
  std::optional<Meaning> key_of_part(const std::string& file, const WrittenName& name);
  void add_signal(const std::string& file, TextRange rest, std::string_view name,
                  std::vector<NamePiece>& found, bool blocks_first = false, int depth = 0);
  void add_parameter(const std::string& file, TextRange range, std::string_view name,
                     std::vector<NamePiece>& found);

  const Registry& registry_;
  OpenTexts texts_;
  Forms forms_;
  std::vector<std::string> folders_;
  std::map<std::string, NamesOf> names_;
};

}  // namespace stepwire::language
