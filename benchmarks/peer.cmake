# What the comparisons with other programs share.

# Timed code is optimised whatever the preset, and without assertions.
function(contact_timed target)
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_compile_options(${target} PRIVATE -O2 -U_GLIBCXX_ASSERTIONS)
  target_compile_definitions(${target} PRIVATE NDEBUG)
endfunction()

# A program that compares, PROGRAM.cpp: it is not part of the default build. What follows is linked.
function(contact_add_comparison program)
  add_executable(${program} EXCLUDE_FROM_ALL ${program}.cpp)
  target_link_libraries(${program} PRIVATE ${ARGN} contact_warnings)
  contact_timed(${program})
endfunction()

# The peer in peer_NAME.cpp becomes a library PROGRAM_NAME, and the program is told by CONTACT_HAS_NAME. A peer's own code keeps
# its own arithmetic: CGAL's intervals and the floats of others are compiled as they come, so it does not link the book.
# INCLUDE: where the peer's headers are; what follows LINK is linked.
function(contact_add_peer program name)
  cmake_parse_arguments(PARSE_ARGV 2 peer "" "" "INCLUDE;LINK")
  set(library ${program}_${name})
  add_library(${library} STATIC EXCLUDE_FROM_ALL peer_${name}.cpp)
  contact_timed(${library})
  target_include_directories(${library} SYSTEM PRIVATE ${peer_INCLUDE})
  target_link_libraries(${library} PUBLIC ${peer_LINK})
  string(TOUPPER ${name} upper)
  target_compile_definitions(${program} PRIVATE CONTACT_HAS_${upper})
  target_link_libraries(${program} PRIVATE ${library})
endfunction()

# A peer in C whose sources a package in build/crates brings, if it is there: they are compiled here, without Rust. PATTERN: the
# folder with the peer's include and src, under that of the packages. A macro, since a language is enabled for the whole folder.
macro(contact_add_c_peer program name pattern)
  file(GLOB ${name}_source LIST_DIRECTORIES true "${PROJECT_SOURCE_DIR}/build/crates/registry/src/*/${pattern}")
  if(${name}_source)
    enable_language(C)
    file(GLOB ${name}_files "${${name}_source}/src/*.c")
    add_library(${program}_${name}_library STATIC EXCLUDE_FROM_ALL ${${name}_files})
    target_include_directories(${program}_${name}_library SYSTEM PRIVATE "${${name}_source}/include" "${${name}_source}/src")
    target_compile_features(${program}_${name}_library PRIVATE c_std_17)
    target_compile_options(${program}_${name}_library PRIVATE -O2 -w)
    target_compile_definitions(${program}_${name}_library PRIVATE NDEBUG)
    contact_add_peer(${program} ${name} INCLUDE "${${name}_source}/include" LINK ${program}_${name}_library m)
  endif()
endmacro()

# CGAL, if its header is there: its numbers are those of GMP and MPFR, and its intervals change the direction of rounding.
function(contact_add_cgal program header)
  find_path(CONTACT_CGAL_INCLUDE CGAL/version.h)
  if(NOT CONTACT_CGAL_INCLUDE OR NOT EXISTS "${CONTACT_CGAL_INCLUDE}/${header}")
    return()
  endif()
  find_library(CONTACT_GMP_LIBRARY gmp)
  find_library(CONTACT_MPFR_LIBRARY mpfr)
  contact_add_peer(${program} cgal INCLUDE "${CONTACT_CGAL_INCLUDE}" LINK "${CONTACT_MPFR_LIBRARY}" "${CONTACT_GMP_LIBRARY}")
  target_compile_options(${program}_cgal PRIVATE -frounding-math)
endfunction()
