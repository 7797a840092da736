// Functions that the kernel is built from, of arguments whose answers closed forms or another computation give.
#include "cases/catalog/kernel_functions/answers.hpp"

namespace plumbline::kernel_functions {
namespace {

constexpr double of_last_place = 1.5;

// In the order of answers.hpp.
const std::vector<KnownTrial> all_functions{
    {"shapes", "weights, gradients and integrals of shapes", "B-splines by the recursion of Cox and de Boor.",
     shapes_trial::shape_answers, few_roundings, rounded},
    {"circles", "normals by circles, tangents of chains",
     "Circles and lines are found exactly, others by least squares.", circles_trial::circle_answers, few_roundings,
     rounded},
    {"surface-fits", "normals by planes and quadratics in space", "Least squares by orthogonal factorisations.",
     circles_trial::surface_fit_answers, few_roundings, rounded},
    {"enclosed", "volumes of nodes inside polygons", "By Green's theorem, of integrals of B-splines.",
     enclosed_trial::enclosed_answers, few_roundings, rounded},
    {"cell-volumes", "volumes of nodes of grids", "Integrals of B-splines between walls, and folded there.",
     enclosed_trial::cell_volume_answers, few_roundings, rounded},
    {"speeds", "speeds of waves that bound the step",
     "Along principal axes, and by row sums of asymmetric deformations.", speeds_trial::speed_answers, few_roundings,
     rounded},
    {"membranes", "membranes in space, now and later", "Of tangents that are set, or sums over places.",
     membranes_trial::membrane_answers, few_roundings, rounded},
    {"layers", "layers of points with tangents", "Strains along tangents, some of them slack.",
     layers_trial::layer_answers, few_roundings, rounded},
    {"chains", "chains of segments and bands", "Strains of segments, some of them slack, and wrinkled bands.",
     chains_trial::chain_answers, few_roundings, rounded},
    {"tensors", "packs of tensors, cubes, sums over lanes", "Eigen on tensors without symmetry, point by point.",
     tensors_trial::tensor_answers, few_roundings, rounded},
    {"logarithms", "logarithms of packs", "In units in the last place, of logarithms of a longer type.",
     tensors_trial::logarithm_answers, of_last_place,
     "off by less than one unit in the last place, and the answer is rounded by half a unit"}};

Case kernel_functions() { return known_answers_case("kernel-functions", all_functions); }
PLUMBLINE_CASE(kernel_functions);

}  // namespace
}  // namespace plumbline::kernel_functions
