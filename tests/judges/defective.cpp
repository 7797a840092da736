// musl with a defect whose size users choose: how small a one do the gates see?
#include "tests/judges/registration.hpp"
#include "tests/judges/steps.hpp"

namespace plumbline::judged {
namespace {

class Defective final : public TimeIntegrator {
  std::vector<IntegratorParameter> parameters() override {
    return {{"strain_defect", &strain_, 0, 1, "of `defective`: the share of each strain that is lost"},
            {"force_defect", &force_, 0, 1, "of `defective`: the share of each force that is lost"},
            {"motion_defect", &motion_, 0, 1, "of `defective`: the share of each point's way that is lost"}};
  }
  void step(Stages& mpm, double dt) override {
    musl(mpm, dt, {.strain = 1 - strain_, .force = 1 - force_, .motion = 1 - motion_});
  }

  double strain_ = 0, force_ = 0, motion_ = 0;
};
PLUMBLINE_INTEGRATOR(Defective, "defective", "musl with a chosen defect", here);

}  // namespace
}  // namespace plumbline::judged
