#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace talus::sweep {

/// Where the parts of a sweep lie in its folder. Paths of members are relative to it: made of digits and our own words.
class SweepFolder {
 public:
  SweepFolder(std::filesystem::path path, std::size_t n_members);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// "0007": as many digits as the last member needs, at least four.
  [[nodiscard]] std::string number(std::size_t member) const;
  [[nodiscard]] std::string member(std::size_t member) const { return "members/" + number(member); }
  [[nodiscard]] std::string scene(std::size_t member) const { return "scenes/" + number(member) + ".toml"; }

 private:
  std::filesystem::path path_;
  std::size_t width_;
};

}  // namespace talus::sweep
