#include "cases/harness/run/budget.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace plumbline {
namespace {

double memory_of_machine() {
  double bytes = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  for (const char* limit : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    std::ifstream file(limit);
    if (double of_group = 0; file >> of_group && of_group > 0) bytes = std::min(bytes, of_group);
  }
  return bytes;
}

// A sanitizer keeps several times the memory of the program for itself. g++ and clang++ tell it each in its own way.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool limits_itself = false;
#elif defined(__has_feature)
constexpr bool limits_itself = !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
constexpr bool limits_itself = true;
#endif

std::string gigabytes(double bytes) { return fmt::format("{:.3g} GB", bytes / 1e9); }

// cells and ppc up to here are built without asking: at most some hundred thousand points in the plane.
constexpr double small_cells = 256, small_ppc = 32;
// Meshes from which larger ones are foreseen; of points per cell the same.
constexpr double coarse = 8, fine = 16, few = 2, more = 4;

SceneSize size_at(const Case& entry, Settings settings, double cells, double ppc) {
  settings.set("cells", cells, entry.name);
  settings.set("ppc", ppc, entry.name);
  return size_of(entry.problem(settings)->unprepared());
}

// How `large` follows from numbers at two sizes, of which the second is twice the first.
double foreseen(double at_first, double at_second, double second, double large) {
  if (at_first <= 0) return at_second;
  const double power = std::clamp(std::log2(at_second / at_first), 0.0, 3.0);
  return at_second * std::pow(large / second, power);
}

}  // namespace

Budget& budget() {
  static Budget all{0.9 * memory_of_machine()};
  return all;
}

void limit_memory() {
  if (!limits_itself) return;
  rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, static_cast<rlim_t>(budget().memory));
  ::setrlimit(RLIMIT_DATA, &limit);
}

UsageError beyond_memory() {
  const std::string allowed = gigabytes(budget().memory);
  return UsageError("--max-memory", allowed, "more than " + allowed, {},
                    fmt::format("more memory is needed than the {} that may be used: choose fewer cells or points, or "
                                "a larger --max-memory",
                                allowed));
}

// The process's largest memory over its points, on meshes of 2.5 to 64 points a cell: 340 to 440 bytes on a line (sod,
// noh-cylindrical), 550 to 680 in the plane (two-disks, mms-vortex, gas-expansion), 900 to 935 in space (mms-axis-aligned), of
// which a cell has 150 to 450. Points are there twice while they are filled and sorted.
double SceneSize::bytes() const { return points * (125 + 250 * dim) + cells * 150 * dim; }

SceneSize size_of(const Scene& scene) {
  SceneSize size;
  size.dim = scene.grid.dim;
  for (const Body& body : scene.bodies) size.points += body.points.points();
  size.cells = 1;
  for (const int along : scene.grid.cells) size.cells *= along;
  return size;
}

SceneSize foreseen_size(const Case& entry, const Settings& settings) {
  const double cells = settings.number("cells"), ppc = settings.number("ppc");
  if (cells <= small_cells && ppc <= small_ppc) return {};
  try {
    const double base_cells = std::min(cells, fine), base_ppc = std::min(ppc, more);
    const SceneSize base = size_at(entry, settings, base_cells, base_ppc);
    SceneSize size = base;
    if (cells > fine) {
      const SceneSize less = size_at(entry, settings, coarse, base_ppc);
      size.points = foreseen(less.points, base.points, fine, cells);
      size.cells = foreseen(less.cells, base.cells, fine, cells);
    }
    if (ppc > more) {
      const SceneSize less = size_at(entry, settings, base_cells, few);
      size.points *= foreseen(less.points, base.points, more, ppc) / base.points;
    }
    return size;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return {};  // so small a scene is none of this case: the limit on allocations remains
  }
}

void require_memory(const SceneSize& size, const Settings& settings) {
  if (size.bytes() <= budget().memory) return;
  const std::string wanted = gigabytes(size.bytes()), allowed = gigabytes(budget().memory);
  throw UsageError(
      "--max-memory", wanted, "at most " + allowed, {},
      fmt::format("{} cells with ppc = {} are about {:.3g} points in {:.3g} cells of the grid, which take "
                  "{}; {} may be used: choose less, or a larger --max-memory",
                  settings.number("cells"), settings.number("ppc"), size.points, size.cells, wanted, allowed));
}

void require_end(double end) {
  if (std::isfinite(end)) return;
  throw UsageError(
      "end time", fmt::format("{}", end), "a finite time", {},
      fmt::format("the end time that follows from the settings is {} s, which no run reaches: less extreme "
                  "values would do",
                  end));
}

void require_steps(double end, double dt, const Settings& settings) {
  const double steps = end / dt, most = budget().steps;
  if (steps <= most) return;
  const std::string key = settings.is_set("dt") ? "dt" : "cfl";
  const double least = settings.number(key) * (steps / most);
  const std::string allowed = std::isfinite(least) ? fmt::format("at least {:.3g}", least) : "larger steps";
  throw UsageError(key, to_text(settings[key]), allowed, {},
                   fmt::format("{} = {}: steps of {:.3g} s to {:.6g} s are {:.3g} steps, more than the {:.3g} that "
                               "--max-steps allows: {} would do",
                               key, to_text(settings[key]), dt, end, steps, most, allowed));
}

}  // namespace plumbline
