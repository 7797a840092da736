// Any bytes as the documents that `diff` and `tolerances` read from files: refused as JSON or as a document, or taken.
#include "cases/harness/compare/bands.hpp"
#include "cases/harness/compare/recording.hpp"
#include "cases/harness/compare/snapshot.hpp"
#include "cases/harness/compare/tolerances.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/json_text.hpp"
#include "tests/hostile/fuzz/memory_file.hpp"

namespace {

using namespace plumbline;

template <class Take>
void take_or_refuse(const Take& take) {
  Snapshot snapshot;
  try {
    take(snapshot);
  } catch (const nlohmann::json::exception&) {
  } catch (const FileError&) {}
}

template <class Read>
void read_or_refuse(const Read& read) {
  try {
    read();
  } catch (const FileError&) {
  } catch (const UsageError&) {}
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static MemoryFile file;
  file.write(bytes, size);
  read_or_refuse([] { read_ledger(file.path()); });
  read_or_refuse([] { read_regressions(file.path()); });
  read_or_refuse([] { read_ensembles(file.path()); });
  Json document;
  try {
    document = parse_json(std::string(bytes, bytes + size));
  } catch (const Json::exception&) {
    return 0;
  }
  read_or_refuse([&] { recorded_from({}, document, "file", ""); });
  take_or_refuse([&](Snapshot& snapshot) { take_study(document, "file", snapshot); });
  take_or_refuse([&](Snapshot& snapshot) { take_verdicts(document, document, snapshot); });
  take_or_refuse([&](Snapshot& snapshot) { take_stability(document, snapshot); });
  take_or_refuse([&](Snapshot& snapshot) { take_costs(document, snapshot); });
  return 0;
}
