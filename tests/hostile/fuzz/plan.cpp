// Any bytes as a plan of `sweep --from`: refused, or a plan all of whose runs are resolved.
#include "cases/harness/verify/plan.hpp"
#include "cases/harness/files/errors.hpp"
#include "reference/parameter.hpp"
#include "tests/hostile/fuzz/memory_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace plumbline;
  static MemoryFile file;
  file.write(bytes, size);
  try {
    const PlanDocument plan(file.path());
    if (plan.has_batches()) {
      for (const Batch& batch : plan.batches()) plan.batch(batch.id);
    }
    to_json(Plan{plan.tier(), {Batch{"one", false, 0, 0, plan.runs()}}});
  } catch (const UsageError&) {
  } catch (const FileError&) {
  } catch (const reference::ParameterError&) {}
  return 0;
}
