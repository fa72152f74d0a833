#include "support/manufactured_box.hpp"

namespace {

using namespace talus;

TEST(LayerManufactured, SourcesAreThoseOfTheReference) {
  for (const char* name : {"newton", "mui_nowall", "mui"}) {
    const auto& c = tests::solution(name).at("parameters");
    auto medium = tests::medium_of(name, c);
    medium.u_s = c.at("us");
    for (const auto& s : tests::solution(name).at("samples")) {
      const auto f = tests::flow_at(tests::flow_of(c), s.at("x"), s.at("z"), s.at("t"));
      const auto b = tests::balance_of(f, medium);
      for (const auto& [key, value] : {std::pair{"u", f.u.value},
                                       {"w", f.w.value},
                                       {"p", f.p.value},
                                       {"eta", b.eta},
                                       {"fx", b.force.x},
                                       {"fz", b.force.z}})
        EXPECT_NEAR(value, s.at(key).get<double>(), 1e-11) << name << " " << key;
    }
  }
}

class LayerManufacturedOrder : public testing::TestWithParam<tests::BoxCase> {};

TEST_P(LayerManufacturedOrder, IsTwoOrOneUpwind) {
  const auto& c = GetParam();
  tests::expect_box_order("layer_manufactured_" + c.solution + "_" + c.grid, c);
}

const auto uniform = grid::Spacing::uniform, clustered = grid::Spacing::clustered;
INSTANTIATE_TEST_SUITE_P(
    Fixed, LayerManufacturedOrder,
    testing::Values(tests::BoxCase{"newton", "uniform", uniform}, tests::BoxCase{"mui_nowall", "uniform", uniform},
                    tests::BoxCase{"mui", "uniform", uniform}, tests::BoxCase{"newton", "stretched", clustered},
                    tests::BoxCase{"mui", "stretched", clustered},
                    tests::BoxCase{"mui", "upwind", uniform, layer::Advection::upwind, {8, 16, 32}, 0.9, 0.9},
                    tests::BoxCase{"newton", "slip", uniform, layer::Advection::central, {8, 16, 32}, 1.8, 1.7, 0.2},
                    tests::BoxCase{
                        "mui", "slip_stretched", clustered, layer::Advection::central, {8, 16, 32}, 1.8, 1.7, 0.2}),
    [](const auto& each) { return each.param.solution + "_" + each.param.grid; });

}  // namespace
