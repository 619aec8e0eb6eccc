# Makes report_assets.cpp in the build folder: the scripts and style sheets that report.html carries.
find_file(FLOWNAV_DYGRAPHS_JS dygraph.min.js PATHS /usr/share/javascript/dygraphs /usr/share/nodejs/dygraphs/dist
          NO_DEFAULT_PATH DOC "The charts of report.html")
find_file(FLOWNAV_DYGRAPHS_CSS dygraph.min.css PATHS /usr/share/javascript/dygraphs /usr/share/nodejs/dygraphs/dist
          NO_DEFAULT_PATH DOC "The style of the charts of report.html")
if(NOT FLOWNAV_DYGRAPHS_JS OR NOT FLOWNAV_DYGRAPHS_CSS)
    message(FATAL_ERROR "dygraph.min.js and dygraph.min.css not found: install the package libjs-dygraphs, or set "
                        "FLOWNAV_DYGRAPHS_JS and FLOWNAV_DYGRAPHS_CSS")
endif()

# Reads a file into a variable, without the comments that make a browser look elsewhere.
function(flownav_asset variable file)
    file(READ ${file} text)
    string(REGEX REPLACE "/[/*][#!] *(sourceMappingURL|@license)[^\n]*\n?" "" text "${text}")
    set(${variable} "${text}" PARENT_SCOPE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
endfunction()
flownav_asset(DYGRAPHS_JS ${FLOWNAV_DYGRAPHS_JS})
flownav_asset(DYGRAPHS_CSS ${FLOWNAV_DYGRAPHS_CSS})
set(REPORT_JS "")
foreach(part base moment charts plan pictures timing main)
    flownav_asset(REPORT_PART ${CMAKE_CURRENT_SOURCE_DIR}/src/report_page/${part}.js)
    string(APPEND REPORT_JS "${REPORT_PART}")
endforeach()
flownav_asset(PAGE_JS ${CMAKE_CURRENT_SOURCE_DIR}/src/pages/base.js)
flownav_asset(PLAN_JS ${CMAKE_CURRENT_SOURCE_DIR}/src/pages/plan_canvas.js)
flownav_asset(PAGE_CSS ${CMAKE_CURRENT_SOURCE_DIR}/src/pages/style.css)
configure_file(src/report_assets.cpp.in report_assets.cpp @ONLY)
