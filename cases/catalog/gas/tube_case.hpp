// A shock tube as a case: what differs between tubes is a table of physics.
#pragma once

#include <string>
#include <vector>

#include "cases/catalog/gas/shock_tube.hpp"

namespace plumbline {

// What differs between tubes, beside what NAME.md says of each.
struct TubeDescription {
  std::string name;
  ShockTube tube;
  double order = 0.8;  // that the fitted order of density.L1 must reach
  bool cold = false;   // a gas with next to no energy: what maps take from points must be returned
  std::string order_reason =
      "shock and contact allow 1; 0.8, as of every shock tube here, leaves a fifth for coarse meshes";
};

// Registers itself with the first mention of a static object, as a case of the file that mentions it.
class TubeCase final : public Case {
 public:
  explicit TubeCase(TubeDescription description, const char* file = __builtin_FILE());

  std::string name() const override { return about_.name; }
  Kind kind() const override { return Kind::gas; }
  Traits needs() const override { return about_.cold ? Traits{Trait::returned_loss} : Traits{}; }
  std::vector<Key> keys() const override { return shock_tube_keys(about_.tube); }
  std::vector<Override> points_and_end(const std::string& scheme) const override;
  void derive(Settings& settings, const std::string& scheme) const override;
  std::unique_ptr<Problem> problem(const Settings& settings) const override;
  std::vector<double> default_levels() const override;
  std::vector<StudyPlan> studies() const override;
  std::vector<CaseGate> gates() const override;
  std::vector<Comparator> comparators(const Settings& settings, const std::vector<double>& cells) const override;

 private:
  TubeDescription about_;
  RegisterCase registered_;
};

}  // namespace plumbline
