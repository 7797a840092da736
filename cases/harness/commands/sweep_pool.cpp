#include "cases/harness/commands/sweep_pool.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <deque>
#include <list>
#include <set>

#include "cases/harness/commands/child_process.hpp"
#include "cases/harness/commands/standard_streams.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/signals.hpp"

namespace plumbline {
namespace {

// The plan where only this process and its children can see it: a file without a name leaves nothing behind.
class HandedPlan {
 public:
  explicit HandedPlan(const Plan& plan) : file_(std::tmpfile()) {
    const std::string text = json_text(to_json(plan));
    const bool written = file_ && std::fwrite(text.data(), 1, text.size(), file_) == text.size();
    if (!written || std::fflush(file_) != 0) throw FileError("plan", "the plan cannot be written to a temporary file");
  }
  ~HandedPlan() {
    if (file_) std::fclose(file_);
  }
  HandedPlan(const HandedPlan&) = delete;
  HandedPlan& operator=(const HandedPlan&) = delete;
  std::string name() const { return fmt::format("/dev/fd/{}", ::fileno(file_)); }

 private:
  std::FILE* file_;
};

// How far a sweep is: one line that changes on a terminal, else a line now and then.
class Meter {
 public:
  Meter(std::size_t of, double estimated_s) : of_(of), estimated_s_(estimated_s) {}
  ~Meter() {
    if (terminal_) fmt::print(stderr, "\r\033[K");
  }
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;

  void add(double estimated_s) {
    ++done_;
    done_s_ += estimated_s;
  }
  void show() {
    const auto now = Clock::now();
    const double since = std::chrono::duration<double>(now - last_).count();
    const bool whole = done_ == of_ && shown_ != of_;
    if (!whole && since < (terminal_ ? 0.1 : 10.0)) return;
    last_ = now;
    shown_ = done_;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const std::string text = fmt::format("{} of {} runs, {:.3g} runs/s{}", done_, of_,
                                         elapsed > 0 ? static_cast<double>(done_) / elapsed : 0, left(elapsed));
    if (terminal_) {
      const std::size_t width = 24, full = of_ > 0 ? width * done_ / of_ : width;
      fmt::print(stderr, "\r\033[K[{:<{}}] {}", std::string(full, '='), width, text);
      std::fflush(stderr);
    } else {
      print_text(stderr, fmt::format("sweep: {}\n", text));
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::string left(double elapsed) const {
    if (done_ == 0 || done_ == of_ || !(done_s_ > 0)) return {};
    const double seconds = elapsed * (estimated_s_ - done_s_) / done_s_;
    return fmt::format(", about {:.0f} s left", seconds > 0 ? seconds : 0);
  }

  std::size_t of_, done_ = 0, shown_ = 0;
  double estimated_s_, done_s_ = 0;
  Clock::time_point start_ = Clock::now(), last_ = start_;
  bool terminal_ = ::isatty(STDERR_FILENO) != 0;
};

// A batch, or one run of it alone.
struct Job {
  const Batch* batch;
  std::string only = {};
};

struct Worker {
  ChildProcess process;
  Job job;
  std::string last_words = {};
};

class Pool {
 public:
  Pool(const Plan& plan, const PoolOptions& options)
      : plan_(plan),
        options_(options),
        handed_(plan),
        meter_(count(plan), estimate(plan)) {}

  PoolResult run() {
    std::deque<Job> jobs;
    for (const Batch& batch : plan_.batches) jobs.push_back({&batch});
    run_jobs(std::move(jobs));
    std::deque<Job> again;
    for (const Batch& batch : plan_.batches) {
      for (const PlanRun& run : batch.runs) {
        if (done_.count(run.file) == 0) again.push_back({&batch, run.file});
      }
    }
    if (!again.empty())
      print_text(stderr, fmt::format("sweep: {} runs failed, each is tried once more alone\n", again.size()));
    result_ = {};
    run_jobs(std::move(again));
    result_.made = done_.size();
    return result_;
  }

 private:
  static std::size_t count(const Plan& plan) {
    std::size_t runs = 0;
    for (const Batch& batch : plan.batches) runs += batch.runs.size();
    return runs;
  }
  static double estimate(const Plan& plan) {
    double seconds = 0;
    for (const Batch& batch : plan.batches) seconds += batch.estimated_s;
    return seconds;
  }

  void run_jobs(std::deque<Job> jobs) {
    while (!jobs.empty() || !workers_.empty()) {
      while (!jobs.empty() && workers_.size() < static_cast<std::size_t>(options_.jobs)) {
        start(jobs.front());
        jobs.pop_front();
      }
      wait_for_output();
      meter_.show();
      if (interrupted()) return;
    }
  }

  void start(const Job& job) {
    std::vector<std::string> words{"sweep", "--from", handed_.name(), "--batch", job.batch->id};
    if (!job.only.empty()) words.insert(words.end(), {"--only", job.only});
    words.insert(words.end(), {"--pool", std::to_string(::getpid())});
    words.insert(words.end(), options_.words.begin(), options_.words.end());
    workers_.push_back({ChildProcess(words), job});
  }

  // All end at once, and only then is anything said.
  bool interrupted() {
    try {
      throw_if_interrupted();
      return false;
    } catch (const Interrupted&) {
      for (const Worker& worker : workers_) worker.process.ask_to_end();
      workers_.clear();
      throw;
    }
  }

  void wait_for_output() {
    std::vector<pollfd> waited;
    for (const Worker& worker : workers_) waited.push_back({worker.process.descriptor(), POLLIN, 0});
    if (::poll(waited.data(), waited.size(), 200) <= 0) return;
    auto worker = workers_.begin();
    for (const pollfd& at : waited) {
      const auto here = worker++;
      if (at.revents == 0) continue;
      std::vector<std::string> lines;
      const bool more = here->process.read(lines);
      for (const std::string& line : lines) take(line, *here);
      if (more) continue;
      finish(*here, here->process.wait());
      workers_.erase(here);
    }
  }

  void take(const std::string& line, Worker& worker) {
    for (const char* mark : {made_mark, kept_mark}) {
      if (line.rfind(mark, 0) != 0) continue;
      const std::size_t start = std::strlen(mark), end = line.find(' ', start);
      const std::string file = line.substr(start, end == std::string::npos ? end : end - start);
      result_.failed.erase(file);
      if (done_.insert(file).second)
        meter_.add(worker.job.batch->estimated_s / static_cast<double>(worker.job.batch->runs.size()));
      return;
    }
    if (line.rfind(failed_mark, 0) == 0) {
      const std::string text = line.substr(std::strlen(failed_mark));
      const std::size_t end = text.find(": ");
      if (end != std::string::npos) result_.failed[text.substr(0, end)] = text.substr(end + 2);
    } else if (!line.empty()) {
      worker.last_words = line;
    }
  }

  void finish(const Worker& worker, int status) {
    if (status == exit_files) result_.files = true;
    if (status == exit_stopped) result_.misbehaved = true;
    for (const PlanRun& run : worker.job.batch->runs) {
      const bool its_own = worker.job.only.empty() || worker.job.only == run.file;
      if (!its_own || done_.count(run.file) > 0 || result_.failed.count(run.file) > 0) continue;
      result_.failed[run.file] = end_text(status, worker.last_words);
    }
  }

  const Plan& plan_;
  HasChildren that_end_first_;
  PoolOptions options_;
  HandedPlan handed_;
  std::list<Worker> workers_;
  std::set<std::string> done_;
  PoolResult result_;
  Meter meter_;
};

}  // namespace

PoolResult run_pool(const Plan& plan, const PoolOptions& options) { return Pool(plan, options).run(); }

}  // namespace plumbline
