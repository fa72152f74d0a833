#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iomanip>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace talus::tests {

/// A table of results, printed row by row and written to `tables/<name>.csv` in the build folder.
class Table {
 public:
  using Cell = std::variant<double, std::string>;

  /// Heads carry their unit, for example "error of u [m/s]". Throws std::runtime_error where the file cannot be opened.
  Table(const std::string& name, std::vector<std::string> heads) : n_columns_(heads.size()) {
    std::filesystem::create_directories(TALUS_TABLES);
    const auto path = std::filesystem::path(TALUS_TABLES) / (name + ".csv");
    file_.open(path);
    if (!file_) throw std::runtime_error("cannot write " + path.string());
    std::printf("%s\n", name.c_str());
    std::vector<Cell> cells;
    for (auto& head : heads) {
      widths_.push_back(std::max<int>(11, static_cast<int>(head.size())));
      cells.emplace_back(std::move(head));
    }
    write(cells);
  }

  void row(std::initializer_list<Cell> cells) { write(cells); }

 private:
  void write(const std::vector<Cell>& cells) {
    if (cells.size() != n_columns_) throw std::logic_error("Table: a row needs a cell for each column");
    for (std::size_t i = 0; i < cells.size(); ++i) {
      file_ << (i > 0 ? "," : "");
      if (const auto* number = std::get_if<double>(&cells[i])) {
        std::printf("  %*.4g", widths_[i], *number);
        file_ << std::setprecision(10) << *number;
      } else {
        std::printf("  %*s", widths_[i], std::get<std::string>(cells[i]).c_str());
        file_ << std::get<std::string>(cells[i]);
      }
    }
    std::printf("\n");
    file_ << std::endl;
  }

  std::size_t n_columns_;
  std::vector<int> widths_;
  std::ofstream file_;
};

}  // namespace talus::tests
