#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/program.hpp"

/// A newcomer's mistakes in a scene, through the program: exit code 2 and a message that helps, before any work.
namespace {
using talus::support::contents;
using talus::support::Outcome;
using talus::support::outcome_of;
using talus::support::TemporaryFolder;

const std::string heap = TALUS_SOURCE_DIR "/runs/examples/heap_q46.toml";

/// "heap.toml:18:1" in a message becomes "<gap>", the first word of that line: tests then hold whatever is added above.
std::string with_words_for_places(const std::string& message, const std::string& file, const std::string& scene) {
  static const std::regex place(R"(:(\d+):\d+: )");
  std::string out, rest = message;
  for (std::size_t at; (at = rest.find(file)) != std::string::npos;) {
    out += rest.substr(0, at);
    rest.erase(0, at + file.size());
    std::smatch found;
    if (!std::regex_search(rest, found, place, std::regex_constants::match_continuous))
      throw std::runtime_error("no place in " + message);
    std::istringstream lines(scene);
    std::string line;
    for (int i = std::stoi(found[1]); i > 0; --i) std::getline(lines, line);
    out += "<" + line.substr(0, line.find_first_of(" =")) + ">: ";
    rest = found.suffix();
  }
  return out + rest;
}

/// `talus check` of the heap scene in which `from` is replaced by `to`.
Outcome check_with(const std::string& from, const std::string& to, std::vector<std::string> more = {}) {
  const TemporaryFolder folder;
  const std::string file = (folder / "heap.toml").string();
  std::string scene = contents(heap);
  const auto at = scene.find(from);
  if (at == std::string::npos) throw std::runtime_error("the example does not hold " + from);
  std::ofstream(file) << scene.replace(at, from.size(), to);
  more.insert(more.begin(), {"check", file});
  Outcome outcome = outcome_of(TALUS_PROGRAM, more);
  outcome.output = with_words_for_places(outcome.output, file, scene);
  return outcome;
}

struct Mistake {
  std::string name, from, to, message;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.to; }

class BadScene : public testing::TestWithParam<Mistake> {};

TEST_P(BadScene, IsRefusedWithItsPlace) {
  const Outcome outcome = check_with(GetParam().from, GetParam().to);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.output, "talus: " + GetParam().message + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    Scene, BadScene,
    testing::Values(
        Mistake{
            "TypoInAKey", "rho_star =", "rho_sart =",
            "<rho_sart>: grains.rho_sart: unknown key (did you mean grains.rho_star?)\n"
            "<[grains]>: grains.rho_star: missing; expected a number above 0 [kg/m3]: intrinsic density of the grains"},
        Mistake{"TypoInASection", "[integrator]", "[integrater]",
                "<[integrater]>: integrater: unknown section (did you mean integrator?)"},
        Mistake{"TextForANumber", "gap = 0.003 ", "gap = \"3 mm\" ",
                "<gap>: box.gap: expected a number above 0 [m], found the text \"3 mm\""},
        Mistake{"NotANumber", "mu_w = 0.3727", "mu_w = nan",
                "<mu_w>: wall.mu_w: expected a number of at least 0 [1], found the number nan, which is not finite"},
        Mistake{"NegativeGap", "gap = 0.003 ", "gap = -0.003 ",
                "<gap>: box.gap: expected a number above 0 [m], found -0.003"},
        Mistake{"InletOutsideTheBox", "position = 0.11 ", "position = 0.61 ",
                "<position>: inflow.position: the inlet is outside the box; expected a number from 0 to box.length = "
                "0.6 m"},
        Mistake{
            "JetOutsideTheBox", "position = 0.11 ", "position = 0.5 ",
            "<position>: inflow.position: the jet meets the base at x = 0.667664 m and its footprint, 3 inflow.width = "
            "0.024 m to either side, leaves the box of length 0.6 m"},
        Mistake{"PhysicalConstantLeftOut", "gravity = 9.81          # m/s2\n", "",
                "<[box]>: box.gravity: missing; expected a number above 0 [m/s2]: acceleration of gravity, g"},
        Mistake{"LawOutOfOrder", "mu_d = 0.9", "mu_d = 0.3",
                "<law>: rheology.law: classical: mu_d = 0.3 must be at least mu_s = 0.4, or friction would fall as I "
                "grows"},
        Mistake{"StopBeforeStart", "stop = 150.0 ", "start = 200.0\nstop = 150.0 ",
                "<stop>: inflow.stop: expected a time after inflow.start [s]"},
        Mistake{"InflowIntoAPeriodicBox", "gravity = 9.81 ", "periodic = true\ngravity = 9.81 ",
                "<rate>: inflow.rate: a periodic box takes no inflow; expected 0 kg/s"},
        Mistake{"OutputAfterTheEnd", "end = 320.0 ", "end = 100.0 ",
                "<times>: output.times: expected times up to time.end = 100.0 s, found 297.6"},
        Mistake{"NoCapAndNoFloor", "alpha = 1.9", "alpha = 1.9\ncap = \"none\"\nrate_speed = 0.0",
                "<cap>: rheology.cap: without a cap the viscosity needs a floor: rheology.rate_floor or "
                "rheology.rate_speed above 0"},
        Mistake{
            "LidOnAnOpenBox", "gravity = 9.81 ", "surface = \"lid\"\nlid_pressure = 100.0\ngravity = 9.81 ",
            "<surface>: box.surface: a lid closes the box; expected box.periodic = true, or \"wall\" for both box.left "
            "and box.right\n"
            "<rate>: inflow.rate: nothing pours through the lid; expected 0 kg/s, or box.surface = \"free\""},
        Mistake{"LidThatIsNotThere", "gravity = 9.81 ", "lid_speed = 0.1\ngravity = 9.81 ",
                "<lid_speed>: box.lid_speed: there is no lid; expected box.surface = \"lid\""},
        Mistake{
            "BaseThatSlipsAndRubs", "gravity = 9.81 ", "base = \"free_slip\"\nbase_friction = 0.3\ngravity = 9.81 ",
            "<base_friction>: box.base_friction: grains slip along the base without friction; expected no such key, or "
            "box.base = \"no_slip\""},
        Mistake{"BaseThatSlipsTwice", "gravity = 9.81 ",
                "base = \"free_slip\"\nbase_slip_length = 1e-3\ngravity = 9.81 ",
                "<base_slip_length>: box.base_slip_length: grains slip along the base without shear stress; expected 0 "
                "m, or "
                "box.base = \"no_slip\""},
        Mistake{"SlipBackwards", "gravity = 9.81 ", "base_slip_length = -1e-3\ngravity = 9.81 ",
                "<base_slip_length>: box.base_slip_length: expected a number of at least 0 [m], found -0.001"},
        Mistake{"BaseThatSlipsAndMoves", "gravity = 9.81 ", "base = \"free_slip\"\nbase_speed = 0.1\ngravity = 9.81 ",
                "<base_speed>: box.base_speed: grains slip along the base; expected 0 m/s, or box.base = \"no_slip\""},
        Mistake{"WallsThatAreNotThere", "gravity = 9.81 ", "end_walls = \"no_slip\"\ngravity = 9.81 ",
                "<end_walls>: box.end_walls: neither end is a wall; expected \"wall\" for box.left or box.right"},
        Mistake{"NameThatIsNoFolder", "name = \"heap_q46\"", "name = \"../heap\"",
                "<name>: scene.name: expected letters, digits, - and _ only"},
        Mistake{"LayerThinnerThanItsFilm", "name = \"layer\"", "name = \"layer\"\ninitial_thickness = 1e-4",
                "<initial_thickness>: model.initial_thickness: expected at least model.film = 0.0005 m"}),
    [](const auto& mistake) { return mistake.param.name; });

TEST(BadScene, AnOverrideIsHeldToTheSameRules) {
  const Outcome outcome = check_with("mu_s", "mu_s", {"--set", "box.gap=-1", "--set", "grid.layer=8"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.output,
            "talus: --set: box.gap: expected a number above 0 [m], found -1.0\n"
            "--set: grid.layer: unknown key (did you mean grid.layers?)\n");
}

TEST(DoubtfulScene, AGridThatCannotResolveTheLayerIsAWarning) {
  const std::string warning = "warning    the grid cannot resolve the flowing layer: ";
  const Outcome coarse = check_with("layers = 32", "layers = 12");
  EXPECT_EQ(coarse.code, 0);
  EXPECT_NE(coarse.output.find(warning + "3.2 layers within its 5.7 mm, at least 4 are needed"), std::string::npos)
      << coarse.output;
  EXPECT_EQ(check_with("layers = 32", "layers = 16").output.find("warning"), std::string::npos);
  const Outcome wide = check_with("columns = 300", "columns = 30");
  EXPECT_NE(wide.output.find("warning    columns of 20.0 mm do not resolve the jet"), std::string::npos) << wide.output;
}

TEST(DoubtfulScene, AnInflowTooLargeForTheClassicalLawHasNoSteadyState) {
  const std::vector<std::string> classical{"--set", "rheology.law=classical"};
  const Outcome above = check_with("rate = 0.0046", "rate = 0.0046", classical);
  EXPECT_EQ(above.code, 0);
  EXPECT_NE(above.output.find(
                "warning    no steady state exists: the inflow of 0.0046 kg/s is above the largest steady flow of the "
                "classical law, Q_max = 0.00459327 kg/s"),
            std::string::npos)
      << above.output;
  const Outcome below = check_with("rate = 0.0046", "rate = 0.0020", classical);
  EXPECT_NE(below.output.find("a heap of slope 39.4734 degrees"), std::string::npos) << below.output;
  EXPECT_EQ(below.output.find("warning"), std::string::npos) << below.output;
}
}  // namespace
