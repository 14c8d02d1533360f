# CHOLMOD and UMFPACK of SuiteSparse, which before version 7 ship no CMake package files, and the OpenBLAS under them.
# Defines SuiteSparse::CHOLMOD and SuiteSparse::UMFPACK.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
find_library(UMFPACK_LIBRARY umfpack)
find_library(OPENBLAS_LIBRARY openblas)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CHOLMOD
  REQUIRED_VARS CHOLMOD_LIBRARY UMFPACK_LIBRARY OPENBLAS_LIBRARY CHOLMOD_INCLUDE_DIR)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY UMFPACK_LIBRARY OPENBLAS_LIBRARY)
if(CHOLMOD_FOUND)
  foreach(part CHOLMOD UMFPACK)
    if(NOT TARGET SuiteSparse::${part})
      add_library(SuiteSparse::${part} UNKNOWN IMPORTED)
      # linked by name, OpenBLAS comes before any other BLAS that a system may prefer
      set_target_properties(SuiteSparse::${part} PROPERTIES IMPORTED_LOCATION ${${part}_LIBRARY}
        INTERFACE_LINK_LIBRARIES ${OPENBLAS_LIBRARY})
      target_include_directories(SuiteSparse::${part} SYSTEM INTERFACE ${CHOLMOD_INCLUDE_DIR})
    endif()
  endforeach()
endif()
