#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "config/number_csv.hpp"
#include "core/errors.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace talus;

const std::vector<config::CsvColumn> columns{
    {"zeta_deg", "degree", "slope", 0.0, 90.0},
    {"h_stop_m", "m", "thickness", 0.0, std::numeric_limits<double>::infinity()}};

class Csv : public testing::Test {
 protected:
  std::vector<std::vector<double>> read(const std::string& text) {
    std::ofstream(folder_ / "data.csv") << text;
    return config::read_csv(folder_ / "data.csv", columns);
  }
  /// What reading says, without the folder.
  std::string refusal(const std::string& text) {
    try {
      (void)read(text);
    } catch (const core::ConfigError& error) {
      std::string message = error.what();
      const std::string folder = (folder_ / "").string();
      for (auto at = message.find(folder); at != std::string::npos; at = message.find(folder))
        message.erase(at, folder.size());
      return message;
    }
    return "accepted";
  }

 private:
  support::TemporaryFolder folder_;
};

TEST_F(Csv, ReadsNamedColumnsInAnyOrderPastCommentsAndEmptyLines) {
  const auto values = read("# glass beads\nh_stop_m, zeta_deg\n\n0.002 , 24\r\n# a pause\n1e-3,25.5\n");
  EXPECT_EQ(values[0], (std::vector<double>{24.0, 25.5}));
  EXPECT_EQ(values[1], (std::vector<double>{0.002, 0.001}));
}

TEST_F(Csv, AnotherUnitOrNameIsRefusedByItsHeader) {
  EXPECT_EQ(refusal("zeta_deg,h_stop_mm\n24,2\n"),
            "data.csv:1: h_stop_m: missing column; expected a number above 0 [m]: thickness\n"
            "data.csv:1: h_stop_mm: unknown column (did you mean h_stop_m?)");
  EXPECT_EQ(refusal("zeta_deg,zeta_deg,h_stop_m\n"), "data.csv:1: zeta_deg: stands in the header twice");
  EXPECT_EQ(refusal("zeta_deg,h_stop_m,beta\n"), "data.csv:1: beta: unknown column");
}

TEST_F(Csv, EveryBadCellIsNamedWithItsLine) {
  EXPECT_EQ(refusal("zeta_deg,h_stop_m\n24,0.002\n95,0.002\n24,2mm\n24\n25,-1\nnan,inf\n26,\n"),
            "data.csv:3: zeta_deg: expected a number above 0 and below 90 [degree], found '95'\n"
            "data.csv:4: h_stop_m: expected a number above 0 [m], found '2mm'\n"
            "data.csv:5: expected 2 cells, found 1\n"
            "data.csv:6: h_stop_m: expected a number above 0 [m], found '-1'\n"
            "data.csv:7: zeta_deg: expected a number above 0 and below 90 [degree], found 'nan'\n"
            "data.csv:7: h_stop_m: expected a number above 0 [m], found 'inf'\n"
            "data.csv:8: h_stop_m: expected a number above 0 [m], found ''");
}

TEST(CsvColumns, ARangeMayHoldItsEndOrHaveNone) {
  const std::vector<config::CsvColumn> others{{"error_m", "m", "error", 0.0, 1e300, true},
                                              {"x_m", "m", "place", -1e300, 1e300}};
  const support::TemporaryFolder folder;
  const auto file = folder / "data.csv";
  std::ofstream(file) << "error_m,x_m\n0,-3\n";
  EXPECT_EQ(config::read_csv(file, others), (std::vector<std::vector<double>>{{0.0}, {-3.0}}));
  std::ofstream(file) << "error_m,x_m\n-1,y\n";
  try {
    (void)config::read_csv(file, others);
    FAIL() << "expected a refusal";
  } catch (const core::ConfigError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("error_m: expected a number at least 0 [m], found '-1'"), std::string::npos) << text;
    EXPECT_NE(text.find("x_m: expected a number [m], found 'y'"), std::string::npos) << text;
  }
}

TEST_F(Csv, AFileWithoutAHeaderOrNoFileIsRefused) {
  EXPECT_EQ(refusal("# nothing\n"), "data.csv: has no header");
  EXPECT_THROW((void)config::read_csv("no_such_file.csv", columns), core::ConfigError);
}
}  // namespace
