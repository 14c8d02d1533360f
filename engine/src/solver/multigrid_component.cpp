#include "multigrid_component.hpp"

#include <dlfcn.h>

namespace shoreline {
namespace {

/// The component's function, or why it cannot be had.
struct Component {
  MakeMultigrid* make = nullptr;
  std::string problem;

  Component() {
    if (void* library = dlopen(SHORELINE_MULTIGRID_FILE, RTLD_NOW | RTLD_LOCAL))
      make = reinterpret_cast<MakeMultigrid*>(dlsym(library, multigrid_entry));
    if (make == nullptr) problem = dlerror();
  }
};

const Component& component() {
  static const Component loaded;
  return loaded;
}

}  // namespace

bool multigrid_available() { return component().make != nullptr; }

std::string multigrid_missing() {
  return "the component of multigrid cannot be loaded (" + component().problem +
         "); install PETSc (Debian: libpetsc-real-dev) and build Shoreline again, or take \"auto\", \"band\" or "
         "\"cholmod\"";
}

std::unique_ptr<Factors> make_multigrid_factors(const Unknowns& unknowns) {
  if (!multigrid_available()) throw InvalidArgument("multigrid: " + multigrid_missing());
  return std::unique_ptr<Factors>(component().make(unknowns));
}

}  // namespace shoreline
