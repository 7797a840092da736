// An HDF5 identifier that is closed by the function of its kind.
#pragma once

#include <fmt/format.h>
#include <hdf5.h>

#include <string>

#include "cases/harness/files/errors.hpp"

namespace plumbline {

class Hdf5Handle {
 public:
  // id: may be negative, which is for the caller to ask.
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}

  // Throws FileError, "FILE: cannot WHAT", for a negative id.
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t), const std::string& file, const std::string& what)
      : Hdf5Handle(id, close) {
    if (id < 0) throw FileError(file, fmt::format("{}: cannot {}", file, what));
  }
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

}  // namespace plumbline
