# Each reference header must compile alone: one generated source a header, all in one object library a chapter, with
# nothing on the include path but that chapter and those it builds on.
function(contact_compile_headers_alone chapter)
  file(GLOB headers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/chapters/${chapter}/contact/*.hpp")
  set(sources "")
  foreach(header IN LISTS headers)
    get_filename_component(stem "${header}" NAME_WE)
    set(source "${CMAKE_CURRENT_BINARY_DIR}/alone/${chapter}/${stem}.cpp")
    # Twice: a header without an include guard fails here.
    file(CONFIGURE OUTPUT "${source}" CONTENT "#include <contact/${stem}.hpp>\n#include <contact/${stem}.hpp>\n")
    list(APPEND sources "${source}")
  endforeach()
  if(sources)
    add_library(headers_alone_${chapter} OBJECT ${sources})
    target_link_libraries(headers_alone_${chapter} PRIVATE contact_${chapter} contact_warnings)
  endif()
endfunction()
