# Debian 12's packages; each is named in the one target that uses it.
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenImageIO REQUIRED)
find_package(fmt REQUIRED)
find_package(SDL2 REQUIRED)
find_package(embree 3 QUIET)

# OpenImageIO's configuration names a folder of OpenCV headers that need not exist.
get_target_property(oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
list(FILTER oiio_includes EXCLUDE REGEX "opencv")
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES
                                                          "${oiio_includes}")

if(BUILD_TESTING)
  find_package(GTest REQUIRED)
  include(GoogleTest)
endif()
