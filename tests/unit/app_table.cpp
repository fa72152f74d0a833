#include "app/table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {
using namespace talus::app;

const Table table{
    {"state", "", "of what", std::vector<std::string>{"flows", "rests"}},
    {"u", "m/s", "speed", std::vector<double>{0.1, std::nan("")}},
    {"zeta_deg", "degree", "slope", std::vector<double>{1.0 / 3.0, -std::numeric_limits<double>::infinity()}}};

TEST(Table, IsAlignedForPeople) {
  EXPECT_EQ(text_of(table), "state  u    zeta_deg\nflows  0.1  0.3333333333\nrests  -    -\n");
}

TEST(Table, ReadsBackAsTheSameNumbersFromCsv) {
  EXPECT_EQ(csv_of(table), "state,u,zeta_deg\nflows,0.1,0.3333333333333333\nrests,,\n");
}

TEST(Table, NamesUnitsInJsonAndHasNullForWhatIsNoNumber) {
  const auto json = nlohmann::json::parse(json_of(table).dump());
  EXPECT_EQ(json["u"]["unit"], "m/s");
  EXPECT_EQ(json["u"]["description"], "speed");
  EXPECT_EQ(json["u"]["values"][0], 0.1);
  EXPECT_TRUE(json["u"]["values"][1].is_null());
  EXPECT_EQ(json["zeta_deg"]["values"][0], 1.0 / 3.0);
  EXPECT_TRUE(json["zeta_deg"]["values"][1].is_null());
  EXPECT_EQ(json["state"]["values"][1], "rests");
  EXPECT_TRUE(json_of(Table{}).empty());
  EXPECT_EQ(text_of(Table{}), "");
}
}  // namespace
