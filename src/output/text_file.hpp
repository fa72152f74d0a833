#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace talus::output {

/// The text of a file; empty where there is none.
inline std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace talus::output
