#include "config/values.hpp"
#include "sweep/sweep_file.hpp"

namespace talus::sweep {

const config::Schema& sweep_schema() {
  using namespace config;  // NOLINT(google-build-using-namespace): a list of declarations
  static const Schema schema = [] {
    Schema s;
    s.section("sweep", "what this is; a file of its own, for talus sweep");
    s.add(text("name", "short name: letters, digits, - and _; the default folder is out/<name>"));
    s.add(text("title", "one line").fallback(std::string()));
    s.add(text("scene", "scene file of all members, found from the folder of the sweep file"));
    s.add(texts("set", "\"key=value\" for all members, as talus run --set").fallback(std::vector<std::string>{}));

    const auto ranges = [](const Values& v) { return !v.has("axis.values"); };
    s.repeated_section("axis", "a key of the scene and its values; the members are all combinations of the axes");
    s.add(text("key", "dotted key of the scene, for example inflow.rate"));
    s.add(scalars("values", "its values").optional("from, to and count"));
    s.add(number("from", "", "first number, in the key's unit; an integer key takes the nearest integers")
              .required_if("values is absent", ranges));
    s.add(number("to", "", "last number").required_if("values is absent", ranges));
    s.add(integer("count", "how many numbers, the ends among them")
              .at_least(2)
              .optional("a section [sample] draws them"));
    s.add(choice("spacing", {"linear", "logarithmic"}, "equal differences or equal ratios")
              .fallback(std::string("linear")));
    s.add(text("zip", "axes with the same word move together, value by value").optional("it moves on its own"));

    const auto samples = [](const Values& v) { return v.has("sample.members"); };
    s.section("sample", "draws points of all axes that have from and to but no count");
    s.add(choice("method", {"latin_hypercube", "random"},
                 "one point in each of `members` equal parts of every axis, or independent points")
              .fallback(std::string("latin_hypercube")));
    s.add(integer("members", "how many points").at_least(1).at_most(most_members).optional("no sample"));
    s.add(integer("seed", "the same seed draws the same points on every machine")
              .at_least(0)
              .required_if("sample.members is given", samples));
    return s;
  }();
  return schema;
}

}  // namespace talus::sweep
