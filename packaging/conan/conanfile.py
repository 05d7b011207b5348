"""The recipe for Conan 2. In the index of recipes its sources come from conandata.yml; here they are this repository's."""
from pathlib import Path

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, rmdir


class Signum(ConanFile):
    name = "signum"
    version = "0.1.0"
    description = "Exact geometric predicates, and tessellations in four metrics built on them"
    license = "MIT"
    topics = ("computational-geometry", "predicates", "delaunay", "voronoi")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "with_gmp": [True, False], "with_tbb": [True, False],
               "with_highway": [True, False]}
    default_options = {"shared": False, "fPIC": True, "with_gmp": True, "with_tbb": True, "with_highway": True}

    def export_sources(self):
        copy(self, "*", Path(self.recipe_folder).parents[1], self.export_sources_folder, excludes=("build/*", ".git/*"))

    def layout(self):
        cmake_layout(self)

    def validate(self):
        check_min_cppstd(self, 20)

    def requirements(self):
        self.requires("boost/1.86.0", headers=True, libs=False)
        if self.options.with_gmp:
            self.requires("gmp/6.3.0")
            self.requires("mpfr/4.2.1")
        if self.options.with_tbb:
            self.requires("onetbb/2021.12.0")
        if self.options.with_highway:
            self.requires("highway/1.2.0", libs=False)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["SIGNUM_BUILD_TESTS"] = False
        toolchain.cache_variables["SIGNUM_BUILD_TOOL"] = False
        toolchain.cache_variables["SIGNUM_INSTALL"] = True
        toolchain.cache_variables["SIGNUM_WITH_GMP"] = bool(self.options.with_gmp)
        toolchain.cache_variables["SIGNUM_WITH_TBB"] = bool(self.options.with_tbb)
        toolchain.cache_variables["SIGNUM_WITH_HIGHWAY"] = bool(self.options.with_highway)
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, Path(self.package_folder) / "licenses")
        CMake(self).install()
        rmdir(self, Path(self.package_folder) / "share")
        rmdir(self, Path(self.package_folder) / "lib" / "cmake")
        rmdir(self, Path(self.package_folder) / "lib" / "pkgconfig")

    def package_info(self):
        self.cpp_info.libs = ["signum"]
        self.cpp_info.set_property("cmake_file_name", "signum")
        self.cpp_info.set_property("cmake_target_name", "signum::signum")
        self.cpp_info.set_property("pkg_config_name", "signum")
        if self.settings.os in ("Linux", "FreeBSD"):
            self.cpp_info.system_libs = ["m", "pthread"]
