# chapters/NN_slug/ is the only registry: a chapter is whatever folder there has a chapter.toml.

# Sets CONTACT_CHAPTERS to the folders' names, in order.
macro(contact_find_chapters)
  file(GLOB _tomls CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/chapters/*/chapter.toml")
  list(SORT _tomls)
  set(CONTACT_CHAPTERS "")
  foreach(_toml IN LISTS _tomls)
    get_filename_component(_dir "${_toml}" DIRECTORY)
    get_filename_component(_name "${_dir}" NAME)
    list(APPEND CONTACT_CHAPTERS "${_name}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${_toml}")
  endforeach()
endmacro()

# Reads `builds_on = ["a", "b"]`, which stands on one line, from a chapter.toml.
function(contact_read_builds_on chapter out)
  file(STRINGS "${PROJECT_SOURCE_DIR}/chapters/${chapter}/chapter.toml" line REGEX "^builds_on *=")
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
    set(dir "${PROJECT_SOURCE_DIR}/chapters/${chapter}")
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

function(contact_install_headers)
  include(GNUInstallDirs)
  include(CMakePackageConfigHelpers)
  target_include_directories(ContactHours INTERFACE "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  foreach(chapter IN LISTS CONTACT_CHAPTERS)
    if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/chapters/${chapter}/contact")
      install(DIRECTORY "${PROJECT_SOURCE_DIR}/chapters/${chapter}/contact"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.hpp")
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
