# Imported targets SuiteSparse::CHOLMOD and SuiteSparse::UMFPACK. Debian 12 ships neither a CMake package nor a
# pkg-config file for them.
include(FindPackageHandleStandardArgs)

find_path(SuiteSparse_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(SuiteSparse_CHOLMOD_LIBRARY cholmod)
find_library(SuiteSparse_UMFPACK_LIBRARY umfpack)
mark_as_advanced(SuiteSparse_INCLUDE_DIR SuiteSparse_CHOLMOD_LIBRARY SuiteSparse_UMFPACK_LIBRARY)
find_package_handle_standard_args(SuiteSparse REQUIRED_VARS SuiteSparse_CHOLMOD_LIBRARY SuiteSparse_UMFPACK_LIBRARY
                                                            SuiteSparse_INCLUDE_DIR)

foreach(part IN ITEMS CHOLMOD UMFPACK)
  if(SuiteSparse_FOUND AND NOT TARGET SuiteSparse::${part})
    add_library(SuiteSparse::${part} UNKNOWN IMPORTED)
    set_target_properties(SuiteSparse::${part} PROPERTIES
      IMPORTED_LOCATION "${SuiteSparse_${part}_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${SuiteSparse_INCLUDE_DIR}")
  endif()
endforeach()
