// A stored run whose parts are any bytes, under a seal that holds: damaged, or a run. HDF5 itself is not what is tried: below a seal
// that does not hold it never sees a file.
#include <cstring>
#include <filesystem>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/results/restore.hpp"
#include "tests/hostile/fuzz/memory_file.hpp"

namespace {

using namespace plumbline;

// The input's bytes up to the next line that is "--".
std::string next_part(std::string& left) {
  const std::size_t end = left.find("\n--\n");
  std::string part = left.substr(0, end);
  left = end == std::string::npos ? "" : left.substr(end + 4);
  return part;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::string left(bytes, bytes + size);
  const std::string run = next_part(left), ledger = next_part(left), name = next_part(left), loose = left;
  std::vector<double> numbers(loose.size() / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), loose.data(), numbers.size() * sizeof(double));
  // A folder in memory, where there is one.
  static const std::string path = (std::filesystem::exists("/dev/shm") ? "/dev/shm/fuzzed-" : "fuzzed-") +
                                  std::to_string(::getpid()) + ".h5";
  try {
    Hdf5Writer out(path);
    out.text("/restore/run", run);
    out.array("/restore/ledger",
              std::span<const std::uint8_t>(reinterpret_cast<const std::uint8_t*>(ledger.data()), ledger.size()));
    out.numbers("/restore/numbers", numbers);
    out.numbers("/profile/" + (name.empty() || name.find('/') != std::string::npos ? "x" : name.substr(0, 40)),
                numbers);
    out.commit();
    const Hdf5Reader in(path);
    read_stored(in);
    read_restore(in);
  } catch (const FileError&) {
  } catch (const UsageError&) {}
  std::filesystem::remove(path);
  return 0;
}
