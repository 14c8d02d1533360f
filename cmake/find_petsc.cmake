# PETSc with real numbers and MPI under it, for the component of multigrid. Sets PETSC_FOUND, and defines
# PkgConfig::PETSC and MPI::MPI_C.
find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND)
  pkg_check_modules(PETSC QUIET IMPORTED_TARGET PETSc>=3.15)
endif()
if(PETSC_FOUND)
  find_package(MPI QUIET COMPONENTS C)
  set(PETSC_FOUND ${MPI_C_FOUND})
endif()
if(SHORELINE_WITH_MULTIGRID STREQUAL "ON" AND NOT PETSC_FOUND)
  message(FATAL_ERROR "SHORELINE_WITH_MULTIGRID is ON, but pkg-config finds no PETSc 3.15 or later with MPI. "
    "On Debian: apt-get install libpetsc-real-dev pkg-config")
endif()
