#include "cases/harness/results/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <hdf5.h>
#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include <ctime>
#include <fstream>
#include <string_view>
#include <vector>

#include "build_info.hpp"
#include "kernel/engine/stage_queue.hpp"

namespace plumbline {
namespace {

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

constexpr const char* instruction_set() {
#if defined(__AVX512F__)
  return "avx512";
#elif defined(__AVX2__)
  return "avx2";
#elif defined(__SSE2__)
  return "sse2";
#else
  return "baseline";
#endif
}

}  // namespace

Provenance build_provenance() {
  Provenance p;
  p.version = build_info::version;
  p.git = build_info::git;
  p.dirty = build_info::dirty;
  p.compiler = build_info::compiler;
  p.flags = build_info::flags;
  p.cpu = cpu_model();
  p.instruction_set = instruction_set();
  p.fused = fuses_stages();
  p.libraries = {{"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
                 {"hdf5", H5_VERS_INFO},
                 {"gsl", build_info::gsl},
                 {"boost", BOOST_LIB_VERSION},
                 {"fmt", fmt::format("{}", FMT_VERSION)},
                 {"cli11", CLI11_VERSION},
                 {"nlohmann_json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                               NLOHMANN_JSON_VERSION_PATCH)}};
  p.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  return p;
}

std::string stored_command(int argc, const char* const* argv) {
  std::string command = "plumbline";
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    bool dropped = false;
    for (const std::string_view option : {"--results", "--json", "--junit"}) {
      if (word == option) {
        ++k;
        dropped = true;
      } else if (word.rfind(std::string(option) + "=", 0) == 0) {
        dropped = true;
      }
    }
    if (dropped) continue;
    const std::size_t slash = word.rfind('/');
    command += " ";
    command += slash == std::string_view::npos ? word : word.substr(slash + 1);
  }
  return command;
}

}  // namespace plumbline
