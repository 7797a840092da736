#include "kernel/scene.hpp"
#include "kernel/contact/contact.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/transfers/transfer.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/kernel/scenes.hpp"

namespace plumbline::scene_test {
namespace {

template <class Entry>
std::vector<std::string> names(const std::vector<Entry>& choices) {
  std::vector<std::string> all;
  for (const Choice& choice : choices) {
    EXPECT_FALSE(choice.title.empty());
    EXPECT_FALSE(choice.source.empty());
    if (!scenes::of_a_test(choice.name)) all.push_back(choice.name);
  }
  return all;
}

TEST(Scene, NamesItsChoices) {
  EXPECT_EQ(names(shapes()), (std::vector<std::string>{"contiguous-gimp", "cpdi", "cubic", "gimp", "lagrangian-cubic",
                                                       "lagrangian-quadratic", "linear", "quadratic"}));
  EXPECT_EQ(names(transfers()), (std::vector<std::string>{"apic", "blend", "flip", "fmpm", "pic", "xpic"}));
  EXPECT_EQ(names(densities()), (std::vector<std::string>{"cell", "quadratic", "continuity", "grid"}));
  EXPECT_EQ(names(contacts()),
            (std::vector<std::string>{"none", "pairs", "touching", "york-9.7", "york-9.8", "york-9.9"}));
}

TEST(Scene, FindsDensityMethodsByName) {
  EXPECT_EQ(density_method("cell"), DensityMethod::cell);
  EXPECT_EQ(density_method("quadratic"), DensityMethod::quadratic);
  EXPECT_EQ(density_method("continuity"), DensityMethod::continuity);
  EXPECT_EQ(density_method("grid"), DensityMethod::grid);
  EXPECT_THROW(density_method("grids"), std::out_of_range);
}

}  // namespace
}  // namespace plumbline::scene_test
