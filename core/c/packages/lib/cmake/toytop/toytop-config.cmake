# The archive by `find_package(toytop)`. A chip is chosen by TOYTOP_ARCHIVE, the name of a folder beside `cmake`.
get_filename_component(toytop_prefix ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)
if(NOT TOYTOP_ARCHIVE)
    set(TOYTOP_ARCHIVE host)
endif()

set(toytop_file ${toytop_prefix}/lib/${TOYTOP_ARCHIVE}/libtoytop.a)
if(NOT EXISTS ${toytop_file})
    set(toytop_FOUND FALSE)
    set(toytop_NOT_FOUND_MESSAGE "no ${toytop_file}: cargo xtask c-archive --target ${TOYTOP_ARCHIVE}")
    return()
endif()

if(NOT TARGET toytop::toytop)
    add_library(toytop::toytop STATIC IMPORTED)
    set_target_properties(toytop::toytop PROPERTIES
        IMPORTED_LOCATION ${toytop_file}
        INTERFACE_INCLUDE_DIRECTORIES ${toytop_prefix}/include)
endif()
