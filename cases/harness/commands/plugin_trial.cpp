#include "cases/harness/commands/plugin_trial.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <new>
#include <set>
#include <system_error>
#include <thread>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/forked_child.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/signals.hpp"
#include "cases/harness/run/guarded_integrator.hpp"
#include "kernel/choice.hpp"
#include "kernel/integrator_traits.hpp"

namespace plumbline {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto pause = std::chrono::milliseconds(1);  // between two looks at the child

enum class Phase : int { loading, asking, stepping, done, refused };

// What the child has come to, where this process can read it whatever becomes of the child.
struct Report {
  std::atomic<Phase> phase = Phase::loading;
  std::atomic<unsigned> progress = 0;  // counts what it has begun
  char part[96] = {};                  // the one under trial: "integrator mine"
  char text[1024] = {};                // why it is refused, or what ended it
};

template <std::size_t size>
void put(char (&to)[size], const std::string& text) {
  const std::size_t length = std::min(text.size(), size - 1);
  std::memcpy(to, text.data(), length);
  to[length] = '\0';
}

class SharedReport {
 public:
  SharedReport() : at_(::mmap(nullptr, sizeof(Report), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (at_ == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
    new (at_) Report;
  }
  ~SharedReport() { ::munmap(at_, sizeof(Report)); }
  SharedReport(const SharedReport&) = delete;
  SharedReport& operator=(const SharedReport&) = delete;
  Report& operator*() const { return *static_cast<Report*>(at_); }
  Report* operator->() const { return static_cast<Report*>(at_); }

 private:
  void* at_;
};

Report* own_report = nullptr;  // in the child

[[noreturn]] void end_at_terminate() {
  put(own_report->text, std::current_exception() ? what_was_thrown() : "called std::terminate");
  ::_exit(1);
}

void begin(Report& report, Phase phase, const std::string& kind, const std::string& name) {
  put(report.part, kind + " " + name);
  report.phase = phase;
  ++report.progress;
}

void ask(const IntegratorEntry& entry) {
  const auto integrator = entry.make();
  std::set<std::string> names;
  for (const IntegratorParameter& parameter : integrator->parameters()) {
    const std::string what = "its parameter '" + valid_utf8(parameter.name) + "' ";
    if (const std::string why = name_refusal(parameter.name); !why.empty())
      throw std::invalid_argument(what + "is misnamed: " + why);
    if (!names.insert(parameter.name).second) throw std::invalid_argument(what + "is there twice");
    const double value = *parameter.value;
    if (!(parameter.low <= value && value <= parameter.high)) {
      throw std::invalid_argument(
          what + fmt::format("is {}, which is not within its range [{}, {}]", value, parameter.low, parameter.high));
    }
    if (valid_utf8(parameter.description) != parameter.description)
      throw std::invalid_argument(what + "is described by what is no UTF-8");
  }
  integrator->claims();
  integrator->memory();
  integrator->kept();
  entry.copy(*integrator);
}

// "shape mine: why", unless that is how it begins already.
std::string after_prefix(const std::string& prefix, const std::string& why) {
  return why.rfind(prefix, 0) == 0 ? why : prefix + ": " + why;
}

// What the child does; never returns.
[[noreturn]] void try_here(const std::string& path, const std::string& file, const Refusals& known, Report& report) {
  own_report = &report;
  std::set_terminate(end_at_terminate);
  const auto refuse = [&](const std::string& why) {
    put(report.text, why);
    report.phase = Phase::refused;
    ::_exit(0);
  };
  try {
    const PluginEntries entries = load_entries(path, file);
    if (const std::string fault = find_fault(entries); !fault.empty()) refuse(fault);
    for (const CollectedPart& part : entries.parts) {
      begin(report, Phase::asking, part.kind, part.name);
      part.add();
    }
    for (const IntegratorEntry& entry : entries.integrators) {
      if (known.count(entry.name) > 0) continue;
      const IntegratorEntry behind = guarded(entry);
      begin(report, Phase::asking, "integrator", entry.name);
      ask(behind);
      begin(report, Phase::stepping, "integrator", entry.name);
      traits_of(behind);
    }
  } catch (const FileError& error) {
    refuse(error.what());
  } catch (const MisbehavingIntegrator& error) {
    refuse(error.what());
  } catch (const std::exception& error) {
    refuse(after_prefix(report.part, error.what()));
  }
  report.phase = Phase::done;
  ::_exit(0);
}

// Waits until the child has ended, `limit` seconds at most for each thing that it begins. What it did, empty where it came to
// its end.
std::string watch(ForkedChild& child, const Report& report, double limit) {
  unsigned seen = 0;
  auto since = Clock::now();
  while (!child.has_ended()) {
    throw_if_interrupted();
    std::this_thread::sleep_for(pause);
    if (const unsigned now = report.progress; now != seen) {
      seen = now;
      since = Clock::now();
    }
    if (std::chrono::duration<double>(Clock::now() - since).count() < limit) continue;
    child.end();
    return fmt::format("did not return within {:.6g} s", limit);
  }
  if (report.phase == Phase::done || report.phase == Phase::refused) return {};
  return report.text[0] ? report.text : child.how();
}

[[noreturn]] void refuse_file(const std::string& file, const std::string& why) {
  throw FileError(file, after_prefix(fmt::format("plug-in {}", file), why));
}

}  // namespace

PluginEntries load_entries(const std::string& path, const std::string& file) {
  if (::dlopen(path.c_str(), RTLD_NOW | RTLD_NOLOAD)) refuse_file(file, "it is part of this program already");
  std::string error;
  PluginEntries entries;
  entries.parts = collect_parts([&] {
    entries.integrators = collect_registrations([&] {
      try {
        if (!::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) error = ::dlerror();
      } catch (...) {  // some C libraries let exceptions pass, others end the program
        error = "it " + what_was_thrown() + " while it was loaded";
      }
    });
  });
  if (!error.empty()) refuse_file(file, error);
  if (entries.integrators.empty() && entries.parts.empty()) refuse_file(file, "it registers nothing");
  return entries;
}

std::string find_fault(const PluginEntries& entries) {
  std::set<std::string> names;
  const auto fault_of = [&](const std::string& kind, const auto& entry) -> std::string {
    const std::string name = valid_utf8(entry.name);
    if (const std::string why = name_refusal(entry.name); !why.empty())
      return fmt::format("{} '{}': {}", kind, name, why);
    if (!names.insert(kind + " " + name).second) return fmt::format("it registers {} {} twice", kind, name);
    if (valid_utf8(entry.title + entry.source) == entry.title + entry.source) return {};
    return fmt::format("the title or the source of {} {} is no UTF-8", kind, name);
  };
  for (const CollectedPart& part : entries.parts) {
    if (std::string fault = fault_of(part.kind, part); !fault.empty()) return fault;
  }
  for (const IntegratorEntry& entry : entries.integrators) {
    if (std::string fault = fault_of("integrator", entry); !fault.empty()) return fault;
    if (find_integrator(entry.name)) return fmt::format("the name {} is taken by another integrator", entry.name);
    if (!entry.make || !entry.copy) return fmt::format("integrator {} cannot be made and copied", entry.name);
  }
  return {};
}

Refusals try_plugin(const std::string& path, const std::string& file, double limit) {
  Refusals refusals;
  while (true) {
    const SharedReport report;
    ForkedChild child([&] { try_here(path, file, refusals, *report); });
    const HasChildren here;
    const std::string did = watch(child, *report, limit);
    if (report->phase == Phase::refused) refuse_file(file, report->text);
    if (did.empty()) return refusals;
    if (report->phase == Phase::loading) refuse_file(file, did + " while it was loaded");
    if (report->phase == Phase::asking)
      refuse_file(file, fmt::format("{} {} while it was asked of itself", report->part, did));
    const std::string part = report->part;
    refusals[part.substr(part.find(' ') + 1)] = did + " when it was tried";
  }
}

}  // namespace plumbline
