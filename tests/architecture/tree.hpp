#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

/// The source tree as the rules of the house see it.
namespace talus::architecture {

using Strings = std::vector<std::string>;

/// A line `talus_room(name folder ROOMS ... LIBRARIES ...)` of CMakeLists.txt.
struct Room {
  std::string name;
  std::string folder;
  Strings rooms;
  Strings libraries;
};

struct Line {
  int number;  ///< from 1
  std::string text;
};

class Tree {
 public:
  /// Lists the files under `root` without what git ignores (.gitignore: builds, results, caches) and reads the rooms.
  explicit Tree(std::filesystem::path root) : root_(std::move(root)) {
    namespace fs = std::filesystem;
    for (fs::recursive_directory_iterator it(root_), end; it != end; ++it) {
      if (is_ignored(it->path().filename().string(), it.depth())) {
        it.disable_recursion_pending();
      } else if (it->is_regular_file()) {
        files_.push_back(fs::relative(it->path(), root_).generic_string());
      }
    }
    std::sort(files_.begin(), files_.end());
    read_rooms();
  }

  [[nodiscard]] const std::filesystem::path& root() const { return root_; }
  /// Relative to the root, with forward slashes, sorted.
  [[nodiscard]] const Strings& files() const { return files_; }
  [[nodiscard]] const std::vector<Room>& rooms() const { return rooms_; }

  [[nodiscard]] bool has(const std::string& file) const {
    return std::binary_search(files_.begin(), files_.end(), file);
  }

  [[nodiscard]] const Room* room_named(const std::string& name) const {
    const auto it = std::find_if(rooms_.begin(), rooms_.end(), [&](const Room& room) { return room.name == name; });
    return it == rooms_.end() ? nullptr : &*it;
  }

  [[nodiscard]] const Room* room_of(const std::string& file) const {
    const auto it = std::find_if(rooms_.begin(), rooms_.end(),
                                 [&](const Room& room) { return file.starts_with(room.folder + "/"); });
    return it == rooms_.end() ? nullptr : &*it;
  }

  /// Empty for a file that does not exist.
  [[nodiscard]] std::string text(const std::string& file) const {
    std::ifstream in(root_ / file, std::ios::binary);
    const std::string on_disk{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const auto appended = appended_.find(file);
    return appended == appended_.end() ? on_disk : on_disk + appended->second;
  }

  /// As if `text` stood at the end of `file`, a new one perhaps; the disk is not touched.
  void append(const std::string& file, const std::string& text) {
    appended_[file] += text;
    if (!has(file)) files_.insert(std::upper_bound(files_.begin(), files_.end(), file), file);
    read_rooms();
  }

  [[nodiscard]] std::vector<Line> lines(const std::string& file) const {
    std::vector<Line> lines;
    std::istringstream in(text(file));
    for (std::string line; std::getline(in, line);) lines.push_back({static_cast<int>(lines.size()) + 1, line});
    return lines;
  }

 private:
  static bool is_ignored(const std::string& name, int depth) {
    if (name == ".git" || name == ".cache" || name == "__pycache__") return true;
    return depth == 0 &&
           (name.starts_with("build") || name == "out" || name.ends_with(".log") || name == "compile_commands.json");
  }

  void read_rooms() {
    rooms_.clear();
    const std::string cmake = std::regex_replace(text("CMakeLists.txt"), std::regex("#[^\n]*"), "");
    const std::regex call(R"((^|\n)talus_room\(([^)]*)\))");
    for (std::sregex_iterator it(cmake.begin(), cmake.end(), call), end; it != end; ++it) {
      std::istringstream words((*it)[2].str());
      Room room;
      words >> room.name >> room.folder;
      Strings* list = nullptr;
      for (std::string word; words >> word;) {
        if (word == "ROOMS") list = &room.rooms;
        else if (word == "LIBRARIES") list = &room.libraries;
        else if (list) list->push_back(word);
      }
      rooms_.push_back(room);
    }
  }

  std::filesystem::path root_;
  Strings files_;
  std::map<std::string, std::string> appended_;
  std::vector<Room> rooms_;
};

inline bool is_cpp(const std::string& file) { return file.ends_with(".hpp") || file.ends_with(".cpp"); }
inline bool contains(const Strings& list, const std::string& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}
inline std::string at(const std::string& file, const Line& line) {
  return file + ":" + std::to_string(line.number) + ": ";
}

}  // namespace talus::architecture
