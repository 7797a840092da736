// A heavy bob on a string of membrane points swings in the plane. [York section 5.7] Two ways to know the strain, four meshes
// of York's, and three studies of what does not matter to the swing.
#include "cases/catalog/membrane/pendulum_gates.hpp"
#include "cases/catalog/membrane/pendulum_run.hpp"

namespace plumbline::pendulum {
namespace {

std::vector<StudyPlan> studies() {
  return {
      study("default", "default, the walls out of reach",
            "Order 2: the bob's kernel adds the inertia m h^2/4 about the pivot.", {5, 10, 20})
          .in_full({5, 10, 20, 40})
          .pictured(27, 20),
      study("york1997", "York's two coarser meshes in his box", "Fig. 37: the loss shrinks with refinement.", {10})
          .of_york()
          .in_full({5, 10})
          .pictured(36, 10),
      study("york-fine", "York's two finer meshes in his box", "Fig. 37: the loss shrinks with refinement.", {20, 40})
          .of_york()
          .in(Tier::full),
      study("york-half", "York's third mesh, half a swing", "Fig. 37: the loss shrinks with refinement.", {20})
          .of_york()
          .with({{"t_end", 0.75}})
          .in(Tier::full),
      study("york-swing", "York's finest mesh, one swing", "Fig. 37: the loss shrinks with refinement.", {40})
          .of_york()
          .with({{"t_end", 1.25}})
          .in(Tier::full),
      study("york-free", "York's second mesh without the one-way law", "Fig. 38: points align less well.", {10})
          .of_york()
          .with({{"one_way", "no"}})
          .pictured(36),
      study("york-increments", "York's second mesh, strain increments rotated once",
            "Section 5.4.2: what York's code did before it kept the total strain along the tangent.", {10})
          .of_york()
          .with({{"strain", "increments"}, {"t_end", 0.05}}),
      study("york-layers", "York's second mesh, two layers of points through the thickness",
            "Section 5.4.5: nothing makes their stresses equal.", {10})
          .of_york()
          .with({{"layers", 2.0}, {"t_end", 0.25}}),
      study("free", "default without the one-way law", "The bounce on the string is too fast to matter to the swing.",
            {10})
          .with({{"one_way", "no"}})
          .in(Tier::full),
      study("box", "default in York's box", "A wall within a kernel of the bob mirrors it.", {5, 10, 20})
          .with({{"box", "york"}})
          .in(Tier::full),
      accumulated_study("As the default: the string is hardly stretched.", {10}).in_full({5, 10, 20, 40})};
}

Case pendulum() {
  return {.name = "pendulum",
          .kind = Kind::membrane,
          .keys = Swing().keys(),
          .sets = {{"cells", 20.0}},
          .york1997 = {{"cells", 10.0}, {"box", "york"}, {"layout", "york"}, {"t_end", 1.75}, york_strain()},
          .york_step = step_over_cells(2e-4),  // 2e-5 s at h = 0.1 [York A.4.5]
          .problem = pendulum_run,
          .studies = studies(),
          .gates = pendulum_gates(),
          .levels = {5, 10, 20},
          .may_be_undefined = {{"period", "a bob that does not come back has none"}}};
}
PLUMBLINE_CASE(pendulum);

}  // namespace
}  // namespace plumbline::pendulum
