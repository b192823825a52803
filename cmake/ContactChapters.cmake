# chapters/NN_slug/ is the only registry: a chapter is whatever folder there has a chapter.toml. With CONTACT_PACK, the
# chapters of the pack follow those of the book.

# Sets CONTACT_CHAPTERS to the folders' names, in order.
macro(contact_find_chapters)
  file(GLOB _tomls CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/chapters/*/chapter.toml")
  list(SORT _tomls)
  if(CONTACT_PACK)
    file(GLOB _more CONFIGURE_DEPENDS "${CONTACT_PACK}/chapters/*/chapter.toml")
    list(SORT _more)
    list(APPEND _tomls ${_more})
  endif()
  set(CONTACT_CHAPTERS "")
  foreach(_toml IN LISTS _tomls)
    get_filename_component(_dir "${_toml}" DIRECTORY)
    get_filename_component(_name "${_dir}" NAME)
    list(APPEND CONTACT_CHAPTERS "${_name}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${_toml}")
  endforeach()
endmacro()

# The folder with chapters/NN_slug of this chapter: the book's, or the pack's.
function(contact_root_of chapter out)
  set(root "${PROJECT_SOURCE_DIR}")
  if(CONTACT_PACK AND NOT EXISTS "${root}/chapters/${chapter}/chapter.toml")
    set(root "${CONTACT_PACK}")
  endif()
  set(${out} "${root}" PARENT_SCOPE)
endfunction()

# Reads `builds_on = ["a", "b"]`, which stands on one line, from a chapter.toml.
function(contact_read_builds_on chapter out)
  contact_root_of("${chapter}" root)
  file(STRINGS "${root}/chapters/${chapter}/chapter.toml" line REGEX "^builds_on *=")
  string(REGEX MATCHALL "\"[^\"]+\"" quoted "${line}")
  string(REPLACE "\"" "" names "${quoted}")
  foreach(name IN LISTS names)
    if(NOT name IN_LIST CONTACT_CHAPTERS)
      message(FATAL_ERROR "chapters/${chapter}/chapter.toml: builds_on names \"${name}\", and there is no chapters/${name}/")
    endif()
  endforeach()
  set(${out} "${names}" PARENT_SCOPE)
endfunction()

# One INTERFACE target a chapter. Its include path holds that chapter and those it builds on, so that an include
# that the chapter map does not allow does not compile.
function(contact_add_chapter_targets)
  add_library(ContactHours INTERFACE)
  add_library(ContactHours::ContactHours ALIAS ContactHours)
  target_link_libraries(ContactHours INTERFACE contact_options)
  foreach(chapter IN LISTS CONTACT_CHAPTERS)
    contact_root_of("${chapter}" root)
    set(dir "${root}/chapters/${chapter}")
    add_library(contact_${chapter} INTERFACE)
    target_include_directories(contact_${chapter} INTERFACE "$<BUILD_INTERFACE:${dir}>")
    target_link_libraries(contact_${chapter} INTERFACE contact_options)
    target_include_directories(ContactHours INTERFACE "$<BUILD_INTERFACE:${dir}>")
  endforeach()
  foreach(chapter IN LISTS CONTACT_CHAPTERS)
    contact_read_builds_on("${chapter}" earlier)
    foreach(name IN LISTS earlier)
      target_link_libraries(contact_${chapter} INTERFACE contact_${name})
    endforeach()
  endforeach()
endfunction()

# In a large chapter the headers declare and src/*.cpp defines. By default a program that includes such a header also
# includes its source. The programs of this repository link a library in which the sources are compiled once: for
# chapters/20_scenes, contact_scenes, which defines CONTACT_SCENES_COMPILED for the targets that link it.
function(contact_add_chapter_libraries)
  find_package(nlohmann_json 3.11 REQUIRED)
  foreach(chapter IN LISTS CONTACT_CHAPTERS)
    file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/chapters/${chapter}/src/*.cpp")
    if(NOT sources)
      continue()
    endif()
    contact_chapter_name("${chapter}" name)
    string(TOUPPER "CONTACT_${name}_COMPILED" compiled)
    add_library(contact_${name} STATIC ${sources})
    target_compile_definitions(contact_${name} PUBLIC ${compiled})
    target_link_libraries(contact_${name} PUBLIC contact_${chapter} nlohmann_json::nlohmann_json PRIVATE contact_warnings)
    contact_compile_by_first_word(contact_${name} ${sources})
    contact_may_ignore_scopes("${chapter}" contact_${name})
    target_precompile_headers(contact_${name} PRIVATE <Eigen/Core> <Eigen/Geometry> <filesystem> <functional> <map>
      <memory> <optional> <string> <vector> <nlohmann/json.hpp>)
    # Optimised, also in builds for debugging, because running a scene takes long.
    if(NOT CONTACT_SANITIZE AND NOT CONTACT_COVERAGE)
      target_compile_options(contact_${name} PRIVATE -O2)
    endif()
  endforeach()
endfunction()

# 20_scenes: scenes.
function(contact_chapter_name chapter out)
  string(REGEX REPLACE "^[0-9]+_" "" name "${chapter}")
  set(${out} "${name}" PARENT_SCOPE)
endfunction()

# What a program of the tree links to use a chapter: its library if it has one, else its headers and the libraries of
# the chapters that it builds on.
function(contact_chapter_library chapter out)
  contact_chapter_name("${chapter}" name)
  set(found contact_${chapter})
  if(TARGET contact_${name})
    set(found contact_${name})
  endif()
  contact_read_builds_on("${chapter}" earlier)
  foreach(one IN LISTS earlier)
    contact_chapter_name("${one}" name)
    if(TARGET contact_${name})
      list(APPEND found contact_${name})
    endif()
  endforeach()
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

# Files whose names begin with the same word are compiled as one: they use the same headers, whose inline functions would
# be compiled again for each.
function(contact_compile_by_first_word target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS ARGN)
    get_filename_component(file "${source}" NAME)
    string(REGEX MATCH "^[a-z0-9]+" word "${file}")
    set_property(SOURCE "${source}" PROPERTY UNITY_GROUP ${word})
  endforeach()
endfunction()

# Where a program's time does not matter, builds for debugging optimise less: a quarter less time to compile.
function(contact_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Debug>:-Og>)
endfunction()

# The files of one room of a library or program are compiled as one, up to eight at a time: half of the time goes into
# templates of the standard library that each would make again. With -DCONTACT_COMPILE_TOGETHER=OFF each is compiled by
# itself, which is faster while one of them is edited.
option(CONTACT_COMPILE_TOGETHER "Compile files of the grader and the program together" ON)
function(contact_compile_together target)
  if(CONTACT_COMPILE_TOGETHER)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    # A class of one file may have members of types that only this file has.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# In a folder of their own, contact/ beside src/: a header takes its source in as ../../src/NAME.cpp.
function(contact_install_headers)
  include(GNUInstallDirs)
  include(CMakePackageConfigHelpers)
  set(folder "${CMAKE_INSTALL_INCLUDEDIR}/ContactHours")
  target_include_directories(ContactHours INTERFACE "$<INSTALL_INTERFACE:${folder}>")
  foreach(chapter IN LISTS CONTACT_CHAPTERS)
    if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/chapters/${chapter}/contact")
      install(DIRECTORY "${PROJECT_SOURCE_DIR}/chapters/${chapter}/contact"
        DESTINATION "${folder}" FILES_MATCHING PATTERN "*.hpp")
    endif()
    if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/chapters/${chapter}/src")
      install(DIRECTORY "${PROJECT_SOURCE_DIR}/chapters/${chapter}/src"
        DESTINATION "${folder}" FILES_MATCHING PATTERN "*.cpp" PATTERN "*.hpp")
    endif()
  endforeach()
  set(config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/ContactHours")
  install(TARGETS ContactHours contact_options EXPORT ContactHoursTargets)
  install(EXPORT ContactHoursTargets NAMESPACE ContactHours:: DESTINATION "${config_dir}")
  configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/ContactHoursConfig.cmake.in"
    "${CMAKE_CURRENT_BINARY_DIR}/ContactHoursConfig.cmake" INSTALL_DESTINATION "${config_dir}")
  write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/ContactHoursConfigVersion.cmake"
    COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/ContactHoursConfig.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/ContactHoursConfigVersion.cmake" DESTINATION "${config_dir}")
endfunction()
