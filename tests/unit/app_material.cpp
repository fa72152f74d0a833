#include "app/material.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "app/number_list.hpp"
#include "core/errors.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace talus;
using Numbers = std::vector<double>;

constexpr const char* table_2 = R"([box]
gap = 0.003
gravity = 9.81
[grains]
rho_star = 2500.0
Phi = 0.6
d = 0.00073
[rheology]
law = "partially_regularised"
mu_s = 0.4
mu_d = 0.9
mu_inf = 1.3
I_0 = 1.3
I_N = 0.05178
alpha = 1.9
[wall]
mu_w = 0.3727
)";

class Material : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& text) const {
    std::ofstream(folder_ / "material.toml") << text;
    return folder_ / "material.toml";
  }
  static std::string refusal(const auto& act) {
    try {
      act();
    } catch (const core::ConfigError& error) { return error.what(); }
    return "";
  }

 private:
  support::TemporaryFolder folder_;
};

TEST_F(Material, IsReadFromAFileOfItsOwnAndFromAScene) {
  const auto channel = app::read_material(file(table_2));
  EXPECT_EQ(channel.gap, 0.003);
  EXPECT_EQ(channel.mu_w, 0.3727);
  EXPECT_EQ(channel.grains.rho(), 1500.0);
  EXPECT_EQ(rheology::name(channel.law), "partially regularised");
  const auto scene = app::read_material(std::filesystem::path(TALUS_SOURCE_DIR) / "runs/examples/heap_q46.toml");
  EXPECT_EQ(rheology::friction(scene.law, 0.3), rheology::friction(channel.law, 0.3));
}

TEST_F(Material, TakesAnotherLawByAnOverride) {
  const auto channel = app::read_material(file(table_2), {"rheology.law=classical"});
  EXPECT_EQ(rheology::friction_at_rest(channel.law), 0.4);
}

TEST_F(Material, RefusesWhatIsMissingUnknownOrInadmissible) {
  const auto missing = refusal([&] { (void)app::read_material(file("[box]\ngap = 0.003\n")); });
  for (const char* key : {"box.gravity", "grains.d", "rheology.mu_s", "wall.mu_w"})
    EXPECT_NE(missing.find(key), std::string::npos) << missing;
  EXPECT_EQ(missing.find("grid.columns"), std::string::npos) << missing;
  const auto unknown = refusal([&] { (void)app::read_material(file(std::string(table_2) + "mu_x = 1\n")); });
  EXPECT_NE(unknown.find("material.toml:18:1: wall.mu_x: unknown key (did you mean wall.mu_w?)"), std::string::npos)
      << unknown;
  const auto falling = refusal([&] { (void)app::read_material(file(table_2), {"rheology.mu_d=0.3"}); });
  EXPECT_NE(falling.find("mu_d = 0.3 must be at least mu_s = 0.4"), std::string::npos) << falling;
}

TEST(NumberList, ReadsNumbersAndRanges) {
  EXPECT_EQ(app::number_list("30,45.5", "--zeta", "degree"), (Numbers{30.0, 45.5}));
  EXPECT_EQ(app::number_list("30:50:5", "--zeta", "degree"), (Numbers{30.0, 35.0, 40.0, 45.0, 50.0}));
  EXPECT_EQ(app::number_list("5:1:-2", "", ""), (Numbers{5.0, 3.0, 1.0}));
  EXPECT_EQ(app::number_list("7:7:1", "", ""), Numbers{7.0});
  EXPECT_EQ(app::number_list("0:0.3:0.1", "", "").size(), 4U);
  EXPECT_EQ(app::number_list("0:0.35:0.1", "", "").size(), 4U);
  const auto factors = app::number_list("1,1e-2:1e2:x5", "", "");
  ASSERT_EQ(factors.size(), 6U);
  EXPECT_NEAR(factors[2], 0.1, 1e-15);
  EXPECT_EQ(factors.back(), 100.0);
}

TEST(NumberList, RefusesWhatIsNone) {
  for (const char* text : {"", "1,", "a", "1:2", "1:2:0", "2:1:0.5", "1:2:1e-9", "nan", "inf", "0:1:x3", "1:2:x1",
                           "1:2:x2.5", "1;2", "1e999"})
    EXPECT_THROW((void)app::number_list(text, "--zeta", "degree"), core::ConfigError) << text;
  try {
    (void)app::number_list("30,4o", "--zeta", "degree");
    FAIL();
  } catch (const core::ConfigError& error) {
    EXPECT_STREQ(error.what(), "--zeta: expected finite numbers [degree], found '4o'");
  }
}
}  // namespace
