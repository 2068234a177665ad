# find_library_by_header(TARGET HEADER LIBRARY PACKAGE): an imported target for a library that has no CMake
# files of its own everywhere.
function(find_library_by_header target header library package)
  string(MAKE_C_IDENTIFIER "CLOTHLAB_${library}" name)
  find_path(${name}_INCLUDE_DIR ${header})
  find_library(${name}_LIBRARY ${library})
  mark_as_advanced(${name}_INCLUDE_DIR ${name}_LIBRARY)
  if(NOT ${name}_INCLUDE_DIR OR NOT ${name}_LIBRARY)
    message(FATAL_ERROR "lib${library} or its header ${header} is missing; install ${package} (Debian's name)")
  endif()
  add_library(${target} UNKNOWN IMPORTED GLOBAL)
  set_target_properties(${target} PROPERTIES
    IMPORTED_LOCATION ${${name}_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${${name}_INCLUDE_DIR})
endfunction()
