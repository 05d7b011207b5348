# Headers, library, tool and a package file: find_package(signum) then links signum::signum.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
install(TARGETS signum EXPORT signum-targets)
install(TARGETS signum_warnings EXPORT signum-targets)
