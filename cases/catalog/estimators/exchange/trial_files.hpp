// Files that trials write, and the cases of which they are: the shock tube's, with a scene of a few points instead of its own.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/estimators/known_answers.hpp"
#include "cases/harness/exchange/foreign_reader.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/scratch_folder.hpp"
#include "cases/harness/run/judged_at_end.hpp"

namespace plumbline {

inline constexpr double end_of_given = 2;  // s

// Measures of all kinds of names, with errors known beforehand.
class GivenScene : public Problem {
 public:
  explicit GivenScene(Scene (*made_by)()) : scene_(made_by) {}
  Scene scene() const override { return scene_(); }
  double end_time() const override { return end_of_given; }
  std::vector<Measure> measures(const Simulation&) const override {
    return {{"height.L1", 0.25, 1, {}, {}, 0, "m"},   {"height.L2", 0.5, 1, {}, {}, 0, "m"},
            {"height.Linf", 0.75, 1, {}, {}, 0, "m"}, {"distance", 0.125, 1, {}, {}, 0, "m"},
            scalar_measure("count", 3, 2, 0, "1"),    scalar_measure("seen", 3, 2, 0, "1")};
  }
  Profile profile(const Simulation&) const override { return {}; }

 private:
  Scene (*scene_)();
};
class GivenEnd final : public GivenScene, public JudgedAtEnd {
 public:
  using GivenScene::GivenScene;
  std::vector<std::string> seen_on_the_way() const override { return {"seen"}; }
};

template <class Given>
Case case_of_given(Scene (*scene)(), Kind kind) {
  Case made = find_case("sod");
  made.kind = kind;
  made.problem = [scene](const Settings&) { return std::make_unique<Given>(scene); };
  return made;
}
inline Settings settings_of_given() { return find_case("sod").settings("default", {{"cells", 20.0}}); }

// What a dataset holds, row after row, and its shape.
void add_table(const std::string& name, const ForeignReader& file, const std::string& dataset,
               const std::vector<std::size_t>& shape, const std::vector<double>& values, KnownAnswers& all);

template <class Work>
bool refuses(const Work& work) {
  return throws<FileError>(work);
}

}  // namespace plumbline
