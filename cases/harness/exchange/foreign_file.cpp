#include "cases/harness/exchange/foreign_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <exception>
#include <functional>
#include <new>
#include <optional>
#include <system_error>
#include <type_traits>
#include <utility>

#include "cases/harness/exchange/foreign_reader.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/forked_child.hpp"
#include "cases/harness/files/hdf5_handle.hpp"
#include "cases/harness/files/signals.hpp"

namespace plumbline {
namespace {

using Clock = std::chrono::steady_clock;

enum class Question : char { open, has, members, text, number, numbers };
enum class Reply : char { answer, refused, no_memory };

// One end of a stream between two processes; what is sent are values, counts before what they count.
class End {
 public:
  explicit End(int descriptor) : descriptor_(descriptor) {}
  ~End() { close(); }
  End(const End&) = delete;
  End& operator=(const End&) = delete;

  void close() {
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  }
  int descriptor() const { return descriptor_; }

  // False where the other end is gone.
  bool send(const void* data, std::size_t bytes) const {
    const char* from = static_cast<const char*>(data);
    while (bytes > 0) {
      const ssize_t sent = ::send(descriptor_, from, bytes, MSG_NOSIGNAL);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) return false;
      from += sent;
      bytes -= static_cast<std::size_t>(sent);
    }
    return true;
  }

  // What there is by now, at most so many bytes; 0: the other end is gone.
  std::size_t receive_some(void* data, std::size_t bytes) const {
    ssize_t count = 0;
    do {
      count = ::recv(descriptor_, data, bytes, 0);
    } while (count < 0 && errno == EINTR);
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }

 private:
  int descriptor_;
};

// Writes and reads values, as `send` and `receive` move bytes.
template <class Send>
struct Sender {
  Send send;
  template <class Value>
  void put(const Value& value) const {
    static_assert(std::is_trivially_copyable_v<Value>);
    send(&value, sizeof value);
  }
  template <class Value>
  void put_all(const Value* values, std::size_t count) const {
    put(count);
    send(values, count * sizeof(Value));
  }
  void put_text(const std::string& text) const { put_all(text.data(), text.size()); }
};
template <class Send>
Sender(Send) -> Sender<Send>;

template <class Receive>
struct Receiver {
  Receive receive;
  template <class Value>
  Value get() const {
    static_assert(std::is_trivially_copyable_v<Value>);
    Value value{};
    receive(&value, sizeof value);
    return value;
  }
  template <class All>
  All get_all() const {
    All all(get<std::size_t>(), typename All::value_type{});
    receive(all.data(), all.size() * sizeof(typename All::value_type));
    return all;
  }
};
template <class Receive>
Receiver(Receive) -> Receiver<Receive>;

struct OtherEndGone {};

// What the child does: answers questions until none can come any more.
void answer_questions(const std::string& path, const End& end) try {
  const auto require = [](bool done) {
    if (!done) throw OtherEndGone();
  };
  const Sender writer{[&](const void* data, std::size_t bytes) { require(end.send(data, bytes)); }};
  const Receiver reader{[&](void* data, std::size_t bytes) {
    for (char* to = static_cast<char*>(data); bytes > 0;) {
      const std::size_t count = end.receive_some(to, bytes);
      require(count > 0);
      to += count;
      bytes -= count;
    }
  }};
  const auto begin = [&] { writer.put(Reply::answer); };
  const auto put_optional = [&](const auto& value, const auto& put) {
    begin();
    writer.put(value.has_value());
    if (value) put(*value);
  };
  std::optional<ForeignReader> file;
  while (true) {
    const auto question = reader.template get<Question>();
    const auto name = reader.template get_all<std::string>();
    try {
      if (question == Question::open) {
        file.emplace(path);
        begin();
      } else if (question == Question::has) {
        const bool found = file->has(name);
        begin();
        writer.put(found);
      } else if (question == Question::members) {
        const std::vector<std::string> names = file->members(name);
        begin();
        writer.put(names.size());
        for (const std::string& each : names) writer.put_text(each);
      } else if (question == Question::text) {
        put_optional(file->text_attribute(name), [&](const std::string& text) { writer.put_text(text); });
      } else if (question == Question::number) {
        put_optional(file->number_attribute(name), [&](double number) { writer.put(number); });
      } else {
        const NumberTable table = file->numbers(name);
        begin();
        writer.put_all(table.shape.data(), table.shape.size());
        writer.put_all(table.values.data(), table.values.size());
      }
    } catch (const FileError& error) {
      writer.put(Reply::refused);
      writer.put_text(error.what());
    } catch (const std::bad_alloc&) {
      writer.put(Reply::no_memory);
    }
  }
} catch (const OtherEndGone&) {}

// HDF5 has one lock for all threads: a process that is split off while another thread holds it would wait for it for ever. Within
// what HDF5 itself calls, as where it makes a list of properties, this thread holds it, and its copy in the new process does.
void under_lock_of_hdf5(const std::string& path, const std::function<void()>& work) {
  struct Call {
    const std::function<void()>& work;
    std::exception_ptr failure;
  } call{work, nullptr};
  const auto run = [](hid_t, void* data) -> herr_t {
    Call& of = *static_cast<Call*>(data);
    try {
      of.work();
    } catch (...) {
      of.failure = std::current_exception();
    }
    return 0;
  };
  const Hdf5Handle kind(H5Pcreate_class(H5P_ROOT, "under lock", run, &call, nullptr, nullptr, nullptr, nullptr),
                        H5Pclose_class, path, "make a class of properties");
  const Hdf5Handle list(H5Pcreate(kind), H5Pclose, path, "make a property list");
  if (call.failure) std::rethrow_exception(call.failure);
}

struct Pair {
  int ends[2];
  Pair() {
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw std::system_error(errno, std::generic_category(), "socketpair");
  }
};

}  // namespace

class ForeignFile::Reading {
  auto reader() {
    return Receiver{[this](void* data, std::size_t bytes) { receive(static_cast<char*>(data), bytes); }};
  }

 public:
  Reading(std::string path, double patience) : Reading(std::move(path), patience, Pair()) {}

  const std::string& path() const { return path_; }

  // Asks, and leaves the answer to be got.
  void ask(Question question, const std::string& name) {
    until_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience_));
    const Sender writer{[&](const void* data, std::size_t bytes) {
      if (!here_.send(data, bytes)) refuse_as_dead();
    }};
    writer.put(question);
    writer.put_text(name);
    const auto kind = get<Reply>();
    if (kind == Reply::no_memory) throw std::bad_alloc();
    if (kind == Reply::refused) throw FileError(path_, get_all<std::string>());
  }

  template <class Value>
  Value get() {
    return reader().template get<Value>();
  }
  template <class All>
  All get_all() {
    return reader().template get_all<All>();
  }

 private:
  Reading(std::string path, double patience, const Pair& pair)
      : path_(std::move(path)),
        patience_(patience),
        here_(pair.ends[0]),
        there_(pair.ends[1]) {
    under_lock_of_hdf5(path_, [this] {
      child_.emplace([this] {
        here_.close();
        answer_questions(path_, there_);
      });
    });
    there_.close();
  }

  void receive(char* to, std::size_t bytes) {
    while (bytes > 0) {
      wait_for_bytes();
      const std::size_t count = here_.receive_some(to, bytes);
      if (count == 0) refuse_as_dead();
      to += count;
      bytes -= count;
    }
  }

  void wait_for_bytes() {
    constexpr int pause = 50;  // ms between two looks for signals
    pollfd wanted{here_.descriptor(), POLLIN, 0};
    while (::poll(&wanted, 1, pause) <= 0) {
      throw_if_interrupted();
      if (Clock::now() < until_) continue;
      child_->end();
      throw FileError(path_, fmt::format("{}: reading it was not done after {:g} s", path_, patience_));
    }
  }

  [[noreturn]] void refuse_as_dead() {
    child_->wait();
    throw FileError(path_, fmt::format("{}: the process that read it {}", path_, child_->how()));
  }

  std::string path_;
  double patience_;
  Clock::time_point until_;
  End here_, there_;
  std::optional<ForkedChild> child_;  // from its making on
};

ForeignFile::ForeignFile(std::string path, double patience)
    : reading_(std::make_unique<Reading>(std::move(path), patience)) {
  reading_->ask(Question::open, "");
}

ForeignFile::~ForeignFile() = default;

const std::string& ForeignFile::path() const { return reading_->path(); }

bool ForeignFile::has(const std::string& object) const {
  reading_->ask(Question::has, object);
  return reading_->get<bool>();
}

std::vector<std::string> ForeignFile::members(const std::string& group) const {
  reading_->ask(Question::members, group);
  std::vector<std::string> names(reading_->get<std::size_t>());
  for (std::string& name : names) name = reading_->get_all<std::string>();
  return names;
}

std::optional<std::string> ForeignFile::text_attribute(const std::string& name) const {
  reading_->ask(Question::text, name);
  if (!reading_->get<bool>()) return std::nullopt;
  return reading_->get_all<std::string>();
}

std::optional<double> ForeignFile::number_attribute(const std::string& name) const {
  reading_->ask(Question::number, name);
  if (!reading_->get<bool>()) return std::nullopt;
  return reading_->get<double>();
}

NumberTable ForeignFile::numbers(const std::string& dataset) const {
  reading_->ask(Question::numbers, dataset);
  NumberTable table;
  table.shape = reading_->get_all<std::vector<std::size_t>>();
  table.values = reading_->get_all<std::vector<double>>();
  return table;
}

}  // namespace plumbline
