# Third-party libraries. This file is also installed: the exported package finds the same ones.
#
# Debian 12 ships no usable CMake package for several of these, so pkg-config is asked for them.
find_package(PkgConfig REQUIRED)
find_package(glm REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(ZLIB REQUIRED)
find_package(Threads REQUIRED)
pkg_check_modules(erfa REQUIRED IMPORTED_TARGET GLOBAL erfa)
pkg_check_modules(cfitsio REQUIRED IMPORTED_TARGET GLOBAL cfitsio)
pkg_check_modules(wcslib REQUIRED IMPORTED_TARGET GLOBAL wcslib)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET GLOBAL tomlplusplus)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET GLOBAL epoxy)
pkg_check_modules(egl REQUIRED IMPORTED_TARGET GLOBAL egl)
# OpenImageIO's own CMake package names targets that Debian does not install.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET GLOBAL OpenImageIO)
