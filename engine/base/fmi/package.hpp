#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/base/fmi/description.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"

namespace stepwire::fmi {

/// The folder of binaries for this machine, as a version of FMI calls it: "binaries/x86_64-linux/".
std::string binary_folder(int version);

/// A unit's file, unpacked: what it says of itself, its binary and its resources.
class Package {
 public:
  /// Throws UnitError: no archive, no modelDescription.xml, another version, no binary for this platform.
  explicit Package(const std::string& path);
  Package(const Package&) = delete;
  Package& operator=(const Package&) = delete;

  const std::string& path() const { return path_; }
  const Description& description() const { return description_; }
  /// The folder of its resources, and the same as a URI for FMI 2.
  std::string resources() const;
  std::string resources_uri() const;
  /// How many instances of it this process has.
  std::atomic<int>& instances() const { return instances_; }
  /// The file of the binary of an interface.
  std::string binary(const Interface& of) const;

 private:
  std::filesystem::path folder() const;
  void unpack_binaries(const class Archive& archive, const Interface& of);

  std::string path_;
  Description description_;
  subprocess::ScratchFolder folder_;
  mutable std::atomic<int> instances_{0};
};

/// The unit of a file; what is open already, and has not changed since, is shared. Safe from several threads.
/// Throws UnitError.
std::shared_ptr<const Package> open_package(const std::string& path);

}  // namespace stepwire::fmi
