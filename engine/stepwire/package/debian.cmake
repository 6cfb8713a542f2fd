# Debian packages of the components, which `cpack` makes in the build folder: stepwire, libstepwire-dev and, where the module is built,
# python3-stepwire.
set(documents ${CMAKE_CURRENT_BINARY_DIR}/documents)
file(MAKE_DIRECTORY ${documents})
# What Debian asks of a package: its licence, and its changes in compressed form, the same bytes each time.
file(READ ${CMAKE_SOURCE_DIR}/LICENSE licence)
file(WRITE ${documents}/copyright "Files of stepwire, under this licence:\n\n${licence}
In the package stepwire, share/stepwire/drawing/node_modules/elkjs is of the Eclipse Layout Kernel, under the Eclipse Public License
2.0, which lies beside it as LICENSE.md. The page of the studio in the program holds libraries under the MIT licence, which the page
itself lists with their texts.
")
execute_process(COMMAND gzip -9nc ${CMAKE_CURRENT_SOURCE_DIR}/changelog OUTPUT_FILE ${documents}/changelog.gz)
function(documents_of package component)
  install(FILES ${documents}/copyright ${documents}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
          COMPONENT ${component})
endfunction()
documents_of(stepwire stepwire)
documents_of(libstepwire-dev development)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME stepwire)
set(CPACK_PACKAGE_VENDOR Stepwire)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL stepwire development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "Stepwire developers <developers@stepwire.invalid>")

set(CPACK_DEBIAN_STEPWIRE_PACKAGE_NAME stepwire)
set(CPACK_DEBIAN_STEPWIRE_PACKAGE_SECTION science)
set(CPACK_DEBIAN_STEPWIRE_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_STEPWIRE_PACKAGE_RECOMMENDS "libstepwire-dev (= ${PROJECT_VERSION}), nodejs, gnuplot-nox, librsvg2-bin")
set(CPACK_COMPONENT_STEPWIRE_DESCRIPTION "block diagrams in text, run at a fixed step
Runs block diagrams that are written as text, checks their units and claims,
and draws diagrams and results. Drawing needs nodejs, plots gnuplot, compiled
runs the package libstepwire-dev.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libstepwire-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "g++, libeigen3-dev, libfmt-dev, libyaml-cpp-dev, libudunits2-dev, libsleef-dev, libxxhash-dev, libmd-dev, libhdf5-dev, zlib1g-dev, libzip-dev, libpugixml-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "cmake, ninja-build")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "block diagrams in text: library and headers
Archives, headers and CMake files for programs that run diagrams or have
blocks of their own, and what the program itself compiles runs with.")

if(TARGET stepwire_python)
  documents_of(python3-stepwire python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-stepwire)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy, stepwire (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-pandas")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "block diagrams in text: module for Python
Loads, runs, sweeps, fits and steps diagrams from Python, with results as
arrays of NumPy.")
endif()
include(CPack)
