#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/base/fmi/description.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"

namespace stepwire::fmi {

/// Returns the folder of binaries for this platform in a version of FMI: "binaries/x86_64-linux/".
std::string binary_folder(int version);

/// An unpacked unit: its description, binary and resources.
class Package {
 public:
  /// Throws UnitError for an invalid archive, a missing modelDescription.xml, another version, or no binary
  /// for this platform.
  explicit Package(const std::string& path);
  Package(const Package&) = delete;
  Package& operator=(const Package&) = delete;

  const std::string& path() const { return path_; }
  const Description& description() const { return description_; }
  /// Returns the folder of its resources; resources_uri() is the same as a URI for FMI 2.
  std::string resources() const;
  std::string resources_uri() const;
  /// Returns the number of its instances in this process.
  std::atomic<int>& instances() const { return instances_; }
  /// Returns the file of an interface's binary.
  std::string binary(const Interface& of) const;

 private:
  std::filesystem::path folder() const;

  std::string path_;
  Description description_;
  subprocess::ScratchFolder folder_;
  mutable std::atomic<int> instances_{0};
};

/// Opens the unit in a file. An open unit whose file has not changed is shared. Thread-safe. Throws
/// UnitError.
std::shared_ptr<const Package> open_package(const std::string& path);

}  // namespace stepwire::fmi
