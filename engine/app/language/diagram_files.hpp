#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/app/language/open_texts.hpp"
#include "engine/app/language/written_names.hpp"

namespace stepwire::language {

/// Definition to which a name refers.
struct Meaning {
  enum class Kind { block, parameter, input, output, port };
  std::string file;
  Kind kind = Kind::block;
  std::string name;  ///< name within that file; for a port preceded by its block: lag.y

  bool operator==(const Meaning&) const = default;
};

/// Piece of a dotted name with its own meaning: "rig" and "x" of "rig.x".
struct NamePiece {
  TextRange range;
  Meaning meaning;
};

/// Range in a file.
struct FilePlace {
  std::string file;
  TextRange range;

  auto operator<=>(const FilePlace&) const = default;
};

/// Index of the open diagram files and those around them; it resolves names across files.
class DiagramFiles {
 public:
  explicit DiagramFiles(const Registry& registry, FileAccess access = {})
      : registry_(registry), texts_(std::move(access)), forms_(registry) {}

  OpenTexts& texts() { return texts_; }
  const Registry& registry() const { return registry_; }
  /// Returns the forms of a file. They are valid until the next call for another file.
  Forms& forms(const std::string& file);
  /// Sets the folders whose files may use the open ones.
  void set_folders(std::vector<std::string> folders) { folders_ = std::move(folders); }

  /// Returns the last valid tree of a file, or nullptr.
  std::shared_ptr<const yaml::Document> tree(const std::string& file) { return texts_.last_document(file); }
  /// Returns all names of the present text; empty if it is no YAML.
  const std::vector<WrittenName>& names(const std::string& file);
  /// Returns the name at an offset, or nullptr.
  const WrittenName* name_at(const std::string& file, std::size_t offset);

  /// Returns the pieces of a name from the left, up to the first one that cannot be resolved.
  std::vector<NamePiece> pieces(const std::string& file, const WrittenName& name);
  std::optional<NamePiece> piece_at(const std::string& file, std::size_t offset);
  /// Returns the key that defines a name, for a port the key of its block; std::nullopt if there is none.
  std::optional<FilePlace> definition(const Meaning& meaning);
  /// Returns all uses of a name in all known files, with its definition.
  std::vector<FilePlace> references(const Meaning& meaning);
  /// Returns the open files and those below the folders.
  std::vector<std::string> paths();

  /// Returns an entry in a section of a file: a block, a parameter or a port; nullptr if there is none.
  static const yaml::Entry* entry(const yaml::Document& document, const char* section,
                                  const std::string& name);
  /// Returns the file of a part that a block entry uses; empty if the entry is no part.
  std::string part_file(const std::string& user, const yaml::Entry& block);
  /// Returns the block whose name is a prefix of the reference, or nullptr. Names of blocks can contain dots.
  static const yaml::Entry* block_at_start(const yaml::Document& document, std::string_view reference);
  /// Returns the outputs of a block or part; empty for an unknown type.
  std::vector<std::string> outputs(const std::string& file, const yaml::Entry& block);
  /// True if the block has a single output, so that its name alone means that output.
  bool has_one_output(const std::string& file, const yaml::Entry& block);

 private:
  /// Returns the path of a part that a file names.
  std::string path_of_part(const std::string& user, const std::string& path);
  struct NamesOf {
    std::shared_ptr<const yaml::Document> document;
    std::vector<WrittenName> names;
  };
  /// Resolves a key that defines a name or that is a key of a block; std::nullopt otherwise.
  std::optional<Meaning> meaning_of_key(const std::string& file, const WrittenName& name);
  std::optional<Meaning> key_of_part(const std::string& file, const WrittenName& name);
  void add_signal(const std::string& file, TextRange rest, std::string_view name,
                  std::vector<NamePiece>& found, bool blocks_first = false, int depth = 0);
  void add_parameter(const std::string& file, TextRange range, std::string_view name,
                     std::vector<NamePiece>& found);

  /// Returns an entry like entry(), by an index of the document.
  const yaml::Entry* indexed(const std::shared_ptr<const yaml::Document>& document, const char* section,
                             std::string_view name);
  /// Returns the block like block_at_start(), by an index of the document.
  const yaml::Entry* indexed_block(const std::shared_ptr<const yaml::Document>& document,
                                   std::string_view reference);

  using Index = std::unordered_map<std::string_view, const yaml::Entry*>;

  const Registry& registry_;
  OpenTexts texts_;
  Forms forms_;
  std::vector<std::string> folders_;
  std::map<std::string, NamesOf> names_;
  std::map<std::pair<std::shared_ptr<const yaml::Document>, std::string>, Index> indices_;  ///< by section
};

}  // namespace stepwire::language
